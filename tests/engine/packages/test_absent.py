"""Well-known packages that are not here."""

from __future__ import annotations

import ast
from pathlib import Path

import pytest

from edulaunch.engine import underlay_place
from edulaunch.engine.packages import Index
from edulaunch.engine.packages.absent import KINDS, REFUSED, absent_kind, absent_module_kind
from edulaunch.ros.sources import read_source


@pytest.mark.parametrize(
    ('package', 'kind'),
    [
        ('gazebo_ros', 'Gazebo'),
        ('nav2_map_server', 'Navigation 2'),
        ('rqt_graph', 'windows'),
        ('urdf_tutorial', 'robot descriptions'),
        ('turtlesim', None),
        ('my_nav2_bringup', None),
        ('', None),
    ],
)
def test_an_absent_package_belongs_to_something(package: str, kind: str | None) -> None:
    assert absent_kind(package) == kind


def test_a_package_of_the_workspace_is_not_absent(tmp_path: Path) -> None:
    (tmp_path / 'urdf').mkdir()
    (tmp_path / 'urdf' / 'package.xml').write_text('<package format="3"><name>urdf</name></package>')
    assert Index((), [tmp_path], read_source=read_source).absent('urdf') is None
    assert Index().absent('urdf') == 'robot descriptions'


def test_only_the_program_tells_that_a_package_is_absent() -> None:
    index = Index()
    program = index.find_program(f'{index.absent_prefix}/lib/joy/joy_node')
    assert program is not None
    assert (program.kind, program.file) == ('absent', 'joysticks and keyboards')
    assert index.prefix('joy') is None
    assert 'joy' not in index.packages()


def test_the_names_are_data_and_none_is_both_refused_and_a_view() -> None:
    assert all(set(names) <= {'packages', 'modules'} and any(names.values()) for names in KINDS.values())
    assert {'pynput', 'pkg_resources', 'PyQt5'} <= REFUSED and not REFUSED & {'tkinter', '_tkinter'}
    assert {absent_module_kind(name) for name in REFUSED} <= set(KINDS)
    assert absent_module_kind('no_such_module') is None
    found = {(kind, name) for kind, names in KINDS.items() for name in names.get('modules', ())}
    assert found == {(absent_module_kind(name), name) for _, name in found}


def test_the_engine_names_no_robots_package() -> None:
    named = {name.strip('*_') for names in KINDS.values() for name in names.get('packages', ())}
    folder = Path(underlay_place.__file__).parent
    texts = {
        node.value
        for path in folder.rglob('*.py')
        for node in ast.walk(ast.parse(path.read_text('utf-8')))
        if isinstance(node, ast.Constant)
    }
    assert named & {text for text in texts if isinstance(text, str)} == set()
