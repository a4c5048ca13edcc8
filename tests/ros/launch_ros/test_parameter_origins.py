"""Where a parameter's value comes from: the line of its key, the file, or the argument that decides it."""

from __future__ import annotations

import linecache
from pathlib import Path
from typing import Any

import pytest
from launch.substitutions import LaunchConfiguration
from launch_ros._parameter_origins import (
    Given,
    GlobalParameter,
    ParameterOrigins,
    argument_in,
    given_by_file,
    given_by_global,
    given_by_launch_file,
    key_lines,
    place_text,
)
from launch_ros._parameter_origins import in_force as in_force_of
from launch_ros.parameter_descriptions import ParameterValue

CALL = """x = 1
Node(
    package='a',
    parameters=[
        {'radius': 2.0,  # 'not': a key
         "speed" : 1, 'text': 'with: colon',
         'nested': {'deep': [1, (2)]}},
    ],
)
Other({'late': 1})
"""


def test_keys_of_a_call_have_their_lines(tmp_path: Path) -> None:
    file = tmp_path / 'a.launch.py'
    file.write_text(CALL)
    linecache.checkcache(str(file))
    assert key_lines(str(file), 2) == {'radius': 5, 'speed': 6, 'text': 6, 'nested': 7, 'deep': 7}
    assert key_lines(str(file), 10) == {'late': 10}


@pytest.mark.parametrize('between', ['', '    # more\n' * 20, '    name="x",\n' * 20, '    text="""\n\'no\': 1\n)\n""",\n'])
def test_a_long_call_and_a_long_text_are_read_to_their_end(tmp_path: Path, between: str) -> None:
    file = tmp_path / 'a.launch.py'
    file.write_text(f'Node(\n{between}    parameters=[{{"a": 1}}],\n)\nOther({{"late": 1}})\n')
    linecache.checkcache(str(file))
    assert key_lines(str(file), 1) == {'a': 2 + between.count('\n')}


def given(pattern: str, name: str, value: Any = 1, origin: str = '', is_of_a_file: bool = False) -> Given:
    return Given(pattern, name, value, origin, '', 0, is_of_a_file)


def test_only_what_is_meant_is_in_force_each_pattern_at_its_first_place() -> None:
    rows = [given('/**', 'a'), given('/n/x', 'b'), given('/other', 'c'), given('/n/x', 'd'), given('/**', 'e')]
    assert [one.name for one in in_force_of(rows, '/n/x')] == ['a', 'e', 'b', 'd']


def test_the_last_one_in_force_is_the_origin_unless_it_is_of_a_file() -> None:
    rows = [given('/**', 'a', origin='one'), given('/**', 'b', origin='file', is_of_a_file=True), given('/**', 'a', origin='two')]
    origins = ParameterOrigins(lambda: rows)
    assert (dict(origins), len(origins), origins['a'], list(origins)) == ({'a': 'two'}, 1, 'two', ['a'])


def test_a_global_parameter_names_its_line_if_it_is_known() -> None:
    assert given_by_global(('a', 1)) == [Given('/**', 'a', 1, 'SetParameter')]
    known = GlobalParameter(('a', 1))
    known.origin = ('/x/b.launch.py', 7)  # type: ignore[assignment]
    assert given_by_global(known) == [Given('/**', 'a', 1, 'SetParameter in b.launch.py line 7', '/x/b.launch.py', 7)]
    assert place_text('/x/b.launch.py', 7) == 'b.launch.py line 7'


def test_a_file_that_cannot_be_read_gives_nothing() -> None:
    def entries(path: str) -> Any:
        if path == '/bad':
            raise ValueError
        return [given('/n', 'a')._replace(line=3)]

    assert given_by_file('/bad', entries) == []
    assert given_by_file('/x/p.yaml', entries) == [Given('/n', 'a', 1, 'p.yaml line 3', '/x/p.yaml', 3, True)]


class Node:
    def __init__(self, file: str, line: int) -> None:
        self.file, self.line = file, line

    def __iter__(self) -> Any:
        return iter((self.file, self.line))


def test_values_of_a_launch_file_have_the_line_of_their_key_or_their_argument(tmp_path: Path) -> None:
    file = tmp_path / 'a.launch.py'
    file.write_text(CALL)
    linecache.checkcache(str(file))
    node: Any = Node(str(file), 2)
    written_here = ParameterValue(1)
    written_here.line = 4
    written = {'radius': 2.0, 'nested.deep': 1, 'other': LaunchConfiguration('x'), 'here': written_here}
    values = dict.fromkeys(written, 1)
    rows = list(given_by_launch_file('/n', values, written, node))
    assert [(one.name, one.origin, one.line) for one in rows] == [
        ('radius', 'a.launch.py line 5', 5),
        ('nested.deep', 'a.launch.py line 7', 7),
        ('other', 'launch argument x', 2),
        ('here', 'a.launch.py line 4', 4),
    ]
    assert [one.origin for one in given_by_launch_file('/n', values, {}, node)] == ['a.launch.py line 2'] * 4
    assert [(one.origin, one.line) for one in given_by_launch_file('/n', values, written, None)] == [('launch file', 0)] * 4


@pytest.mark.parametrize(
    ('value', 'argument'),
    [
        ('a', None),
        (LaunchConfiguration('x'), 'launch argument x'),
        (['a', LaunchConfiguration(['x', 'y'])], 'launch argument xy'),
        ([['a'], ('b', LaunchConfiguration('x'))], 'launch argument x'),
        (ParameterValue(LaunchConfiguration('x')), 'launch argument x'),
        ([['a'], 1.5], None),
    ],
)
def test_the_argument_in_a_value(value: Any, argument: str | None) -> None:
    assert argument_in(value) == argument
