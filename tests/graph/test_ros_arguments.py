"""edulaunch.graph.ros_arguments."""
from __future__ import annotations

from typing import Any

import pytest

from edulaunch.graph.names import RemapRule
from edulaunch.graph.ros_arguments import RosArguments, RosArgumentsError, parse_ros_arguments, without_ros_arguments


def parsed(*arguments: str, **files: str) -> RosArguments:
    return parse_ros_arguments(['--ros-args', *arguments], lambda path: files[path])


def values(arguments: RosArguments, node: str) -> dict[str, Any]:
    return {name: override.value for name, override in arguments.overrides_for(node).items()}


def test_a_section_ends_at_two_dashes_and_may_come_again() -> None:
    result = parse_ros_arguments(['prog', '1', '--ros-args', '-r', 'a:=b', '--', '2', '--ros-args', '-r', 'c:=d'])
    assert (result.others, [rule.match for rule in result.remap_rules]) == (['prog', '1', '2'], ['a', 'c'])


@pytest.mark.parametrize(('text', 'rule'), [
    ('a:=b', RemapRule('any', None, 'a', 'b')),
    ('n:a:=b', RemapRule('any', 'n', 'a', 'b')),
    ('rostopic://a:=b', RemapRule('topic', None, 'a', 'b')),
    ('n:rosservice:///a:=b', RemapRule('service', 'n', '/a', 'b')),
    ('__node:=x', RemapRule('node', None, '__node', 'x')),
    ('__name:=x', RemapRule('node', None, '__name', 'x')),
    ('n:__ns:=x', RemapRule('namespace', 'n', '__ns', '/x')),
])
def test_remap_rules(text: str, rule: RemapRule) -> None:
    assert parsed('-r', text).remap_rules == [rule]


@pytest.mark.parametrize(('arguments', 'text'), [
    (['-r', 'x'], "Couldn't parse remap rule: '-r x'. Error: "),
    (['--remap', '__node:=1'], "Couldn't parse remap rule: '--remap __node:=1'. Error: node name must not start with a number"),
    (['-r'], "Couldn't parse trailing -r flag. No remap rule found."),
    (['-p', 'x=1'], "Couldn't parse parameter override rule: '-p x=1'. Error: "),
    (['-p', 'x:=[1, a]'], "Couldn't parse parameter override rule: '-p x:=[1, a]'. Error: Sequence should be of same type. "),
    (['-p'], "Couldn't parse trailing -p flag. No parameter override rule found."),
    (['--log-level', 'loud'], "Couldn't parse log level rule: '--log-level loud'. Error: "),
])
def test_refused_arguments(arguments: list[str], text: str) -> None:
    with pytest.raises(RosArgumentsError) as caught:
        parsed(*arguments)
    assert str(caught.value).startswith(text)


def test_a_missing_parameter_file_is_refused() -> None:
    with pytest.raises(RosArgumentsError, match="Couldn't parse params file: '--params-file /no'. Error: Error opening YAML file"):
        parse_ros_arguments(['--ros-args', '--params-file', '/no'])


def test_unknown_tokens_are_kept_in_order() -> None:
    assert parsed('--foo', '-r', 'a:=b', '-x').unknown == ['--foo', '-x']


FILE = '/sim:\n  ros__parameters:\n    r: 1\n'


def test_a_later_value_of_the_command_line_beats_an_earlier_file() -> None:
    assert values(parsed('--params-file', 'f', '-p', 'r:=2', f=FILE), '/sim') == {'r': 2}


def test_a_file_beats_an_earlier_value_of_the_command_line() -> None:
    assert values(parsed('-p', 'r:=2', '--params-file', 'f', f=FILE), '/sim') == {'r': 1}


def test_patterns_count_from_their_first_appearance() -> None:
    text = '/**:\n  ros__parameters:\n    q: 0\n' + FILE
    assert values(parsed('--params-file', 'f', '-p', 'r:=2', f=text), '/sim') == {'q': 0, 'r': 1}


def test_values_know_where_they_came_from() -> None:
    result = parsed('--params-file', 'f', '-p', 'n:x:=off', f=FILE)
    assert result.overrides_for('/sim')['r'].origin == 'f line 3'
    assert result.overrides_for('/n')['x'] == (False, 'command line')


def test_levels_and_switches() -> None:
    result = parsed('--log-level', 'DEBUG', '--log-level', 'a.b:=warn', '--disable-stdout-logs', '--enable-rosout-logs')
    assert (result.log_levels, result.outputs) == ({'': 10, 'a.b': 30}, {'stdout': False, 'rosout': True})


def test_the_rest_of_a_command_line() -> None:
    assert without_ros_arguments(['x', '--ros-args', '-r', 'a:=b', '--', 'y']) == ['x', 'y']
