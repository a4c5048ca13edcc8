"""Launch files as robots have them, with all their packages missing: the plan, and what is missing."""

from __future__ import annotations

from pathlib import Path

import pytest

from edulaunch.desk.cli.main import main

ROBOTS = Path(__file__).with_name('robots')


@pytest.mark.parametrize('name', sorted(path.name for path in ROBOTS.glob('*.launch.*') if path.suffix != '.txt'))
def test_the_explanation_of_a_robot_is_the_golden_text(
    name: str, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv('PATH', '/nowhere')
    for name_of_variable in ('LIDAR_MODEL', 'ACME_PORT', 'DISPLAY'):
        monkeypatch.delenv(name_of_variable, raising=False)
    monkeypatch.chdir(ROBOTS.parent)
    assert main(['explain', str(ROBOTS / name), '--assume-packages']) == 0
    shown = capsys.readouterr()
    text = f'{shown.out}\n{shown.err}'.replace(str(ROBOTS), 'robots')
    assert text == (ROBOTS / f'{name}.txt').read_text(encoding='utf-8')
