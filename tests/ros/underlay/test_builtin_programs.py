"""What stands in console_scripts.txt exists, and so does what launch files start."""

from __future__ import annotations

import importlib.util
import re
from pathlib import Path

import pytest

from edulaunch.engine.packages import Index
from edulaunch.engine.underlay_place import underlay_prefix

SHARE = Path(underlay_prefix()) / 'share'
PROGRAMS = [
    (file.parent.name, *re.split(r'\s*=\s*|:', line))
    for file in sorted(SHARE.glob('*/console_scripts.txt'))
    for line in file.read_text(encoding='utf-8').splitlines()
    if line
]
LAUNCH_FILES = sorted(path for path in SHARE.glob('*/launch/**/*launch*') if path.is_file() and path.suffix != '.pyc')


@pytest.mark.parametrize('package, executable, module, function', PROGRAMS)
def test_every_entry_point_is_there(package: str, executable: str, module: str, function: str) -> None:
    own = Path(underlay_prefix()) / 'programs' / f'{module.replace(".", "/")}.py'
    spec = None if own.is_file() else importlib.util.find_spec(module)
    path = own if spec is None or spec.origin is None else Path(spec.origin)
    assert re.search(rf'^(def {function}\(|(\w+ = )*{function} = )', path.read_text(encoding='utf-8'), re.MULTILINE)


def test_turtlesims_executables_are_those_of_the_tutorial() -> None:
    assert Index([], []).executables('turtlesim') == ['draw_square', 'mimic', 'turtle_teleop_key', 'turtlesim_node']


@pytest.mark.parametrize('path', LAUNCH_FILES, ids=lambda path: path.name)
def test_launch_files_start_programs_that_exist(path: Path) -> None:
    text = path.read_text(encoding='utf-8')
    packages = set(re.findall(r'(?:package=\'|pkg="|pkg: )([a-z0-9_]+)', text))
    executables = set(re.findall(r'(?:executable=\'|exec="|exec: )([a-z0-9_.]+)', text))
    known = {executable for package in packages for executable in Index([], []).executables(package)}
    assert executables <= known


@pytest.mark.parametrize('package', sorted({program[0] for program in PROGRAMS}))
def test_every_package_has_a_manifest_of_its_own_name(package: str) -> None:
    assert f'<name>{package}</name>' in (SHARE / package / 'package.xml').read_text(encoding='utf-8')
