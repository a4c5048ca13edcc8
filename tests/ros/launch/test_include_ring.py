"""Launch files that include themselves: legitimate as long as it ends, else an error that names the ring."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from launch import LaunchContext, LaunchDescription, LaunchDescriptionSource
from launch.actions import IncludeLaunchDescription, LogInfo

PYTHON = (
    'from launch import LaunchDescription\nfrom launch.actions import IncludeLaunchDescription\n'
    'from launch.substitutions import PathJoinSubstitution, ThisLaunchFileDir\n'
    'def generate_launch_description():\n    return LaunchDescription([\n'
    "        IncludeLaunchDescription(PathJoinSubstitution([ThisLaunchFileDir(), '{}']))])\n"
)
XML = '<launch>\n  <include file="$(dirname)/{}">{}</include>\n</launch>'
YAML = 'launch:\n- include:\n    file: $(dirname)/{}\n'


@pytest.mark.parametrize(
    ('name', 'text', 'line'),
    [
        ('a.launch.py', PYTHON.format('a.launch.py'), 6),
        ('a.launch.xml', XML.format('a.launch.xml', ''), 2),
        ('a.launch.yaml', YAML.format('a.launch.yaml'), 2),
    ],
)
def test_a_file_that_includes_itself_is_named_with_the_line(
    name: str, text: str, line: int, launch_it: Any, tmp_path: Path
) -> None:
    (tmp_path / name).write_text(text)
    code, lines = launch_it(IncludeLaunchDescription(str(tmp_path / name)))
    assert code == 1
    assert lines[-2].endswith(
        f"launch file '{tmp_path / name}' includes itself without end: {name} includes {name} (line {line})"
    )
    assert lines[-1] == (
        f'  help: {tmp_path / name}:{line} (IncludeLaunchDescription): {name} includes itself; '
        f'remove this include, or give it a condition that becomes false in {name}'
    )


def test_a_ring_of_three_kinds_of_files_is_named_from_where_it_begins(launch_it: Any, tmp_path: Path) -> None:
    (tmp_path / 'a.launch.py').write_text(PYTHON.format('b.launch.xml'))
    (tmp_path / 'b.launch.xml').write_text(XML.format('c.launch.yaml', ''))
    (tmp_path / 'c.launch.yaml').write_text(YAML.format('a.launch.py'))
    (tmp_path / 'outside.launch.xml').write_text(XML.format('b.launch.xml', ''))
    lines = launch_it(IncludeLaunchDescription(str(tmp_path / 'outside.launch.xml')))[1]
    assert lines[-2].endswith(
        f"launch file '{tmp_path}/b.launch.xml' includes itself without end: b.launch.xml includes c.launch.yaml (line 2), "
        'c.launch.yaml includes a.launch.py (line 2), a.launch.py includes b.launch.xml (line 6)'
    )


def test_a_ring_whose_arguments_only_grow_ends_with_the_same_error(launch_it: Any, tmp_path: Path) -> None:
    (tmp_path / 'a.launch.xml').write_text(
        '<launch>\n<arg name="n" default=""/>\n<include file="$(dirname)/a.launch.xml">'
        '<arg name="n" value="x$(var n)"/></include>\n</launch>'
    )
    code, lines = launch_it(IncludeLaunchDescription(str(tmp_path / 'a.launch.xml')))
    assert code == 1
    assert 'includes itself without end: a.launch.xml includes a.launch.xml (line 3)' in lines[-2]


def test_a_file_may_include_itself_until_a_condition_ends_it(launch_it: Any, tmp_path: Path) -> None:
    (tmp_path / 'a.launch.xml').write_text(
        '<launch>\n<arg name="n" default="3"/>\n<log message="n is $(var n)"/>\n'
        '<include file="$(dirname)/a.launch.xml" if="$(eval \'$(var n) > 0\')">'
        '<arg name="n" value="$(eval \'$(var n) - 1\')"/></include>\n</launch>'
    )
    code, lines = launch_it(IncludeLaunchDescription(str(tmp_path / 'a.launch.xml')))
    assert code == 0
    assert [line[-1] for line in lines if '[launch.user]' in line] == ['3', '2', '1', '0']


def test_a_file_may_be_included_twice_in_a_row(launch_it: Any, tmp_path: Path) -> None:
    (tmp_path / 'a.launch.xml').write_text('<launch><log message="here"/></launch>')
    two = [IncludeLaunchDescription(str(tmp_path / 'a.launch.xml')) for _ in range(2)]
    assert launch_it(*two)[0] == 0


def test_descriptions_that_come_from_no_file_may_stand_inside_each_other(launch_it: Any) -> None:
    entities: list[Any] = [LogInfo(msg='inside')]
    for _ in range(3):
        entities = [IncludeLaunchDescription(LaunchDescriptionSource(LaunchDescription(entities)))]
    assert launch_it(*entities) == (0, ['[INFO] [launch.user]: inside'])


def test_an_include_may_be_visited_alone_again_and_again(tmp_path: Path) -> None:
    (tmp_path / 'a.launch.xml').write_text('<launch/>')
    context = LaunchContext()
    for _ in range(3):
        assert len(IncludeLaunchDescription(str(tmp_path / 'a.launch.xml')).visit(context)) == 1  # type: ignore[arg-type]
