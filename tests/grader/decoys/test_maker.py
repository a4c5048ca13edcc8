"""Which files of a package a decoy replaces."""

from __future__ import annotations

from pathlib import Path

import pytest
from edugrade.decoys.maker import _modules

LISTED = "entry_points={'console_scripts': ['talk = robot.talker:main']}"
COMPUTED = "entry_points={'console_scripts': [f'{name} = robot.{name}:main' for name in ('talk', 'hear')]}"


@pytest.mark.parametrize(('setup', 'modules'), [(LISTED, ['robot/talker.py']), (COMPUTED, ['robot/talk.py'])])
def test_the_module_of_a_program_is_found_in_a_list_and_by_its_name(tmp_path: Path, setup: str, modules: list[str]) -> None:
    (tmp_path / 'robot').mkdir()
    (tmp_path / 'robot' / 'talk.py').write_text('')
    (tmp_path / 'setup.py').write_text(setup)
    assert [str(Path(path).relative_to(tmp_path)) for path in _modules(str(tmp_path), 'robot', 'talk')] == modules
