"""What counts as an overlay."""

from __future__ import annotations

from pathlib import Path

import pytest

from edulaunch import Session
from edulaunch.packages.discovery import install_folders


@pytest.mark.parametrize(
    ('sign', 'is_built'),
    [
        ('.colcon_install_layout', True),
        ('local_setup.bash', True),
        ('share/ament_index/x', True),
        ('src/robo/package.xml', False),
    ],
)
def test_folders_that_colcon_installed_into_are_told_from_sources(tmp_path: Path, sign: str, is_built: bool) -> None:
    (tmp_path / sign).parent.mkdir(parents=True, exist_ok=True)
    (tmp_path / sign).write_text('')
    assert install_folders([tmp_path]) == (([str(tmp_path)], []) if is_built else ([], [str(tmp_path)]))


def test_a_session_watches_its_programs_unless_told_not_to() -> None:
    with Session() as session, Session(turn_limit_s=0) as unwatched:
        assert session.host.watchdog is not None and session.host.watchdog.seconds == 10.0
        assert unwatched.host.watchdog is None
