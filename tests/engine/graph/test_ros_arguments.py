"""edulaunch.engine.graph.ros_arguments."""

from __future__ import annotations

import random
import re
from pathlib import Path
from typing import Any

import pytest

from edulaunch.engine.facts import facts_of
from edulaunch.engine.graph import ros_arguments
from edulaunch.engine.graph.names import RemapRule
from edulaunch.engine.graph.parameter_files import read_parameter_file
from edulaunch.engine.graph.ros_arguments import RosArguments, RosArgumentsError, parse_ros_arguments


def parsed(*arguments: str, **files: str) -> RosArguments:
    return parse_ros_arguments(['--ros-args', *arguments], lambda path: read_parameter_file(files[path]))


def values(arguments: RosArguments, node: str) -> dict[str, Any]:
    return {name: override.value for name, override in arguments.overrides_for(node).items()}


def test_a_section_ends_at_two_dashes_and_may_come_again() -> None:
    result = parse_ros_arguments(['prog', '1', '--ros-args', '-r', 'a:=b', '--', '2', '--ros-args', '-r', 'c:=d'])
    assert (result.others, [rule.match for rule in result.remap_rules]) == (['prog', '1', '2'], ['a', 'c'])


@pytest.mark.parametrize(
    ('text', 'rule'),
    [
        ('a:=b', RemapRule('any', None, 'a', 'b')),
        ('n:a:=b', RemapRule('any', 'n', 'a', 'b')),
        ('rostopic://a:=b', RemapRule('topic', None, 'a', 'b')),
        ('n:rosservice:///a:=b', RemapRule('service', 'n', '/a', 'b')),
        ('__node:=x', RemapRule('node', None, '__node', 'x')),
        ('__name:=x', RemapRule('node', None, '__name', 'x')),
        ('n:__ns:=/x', RemapRule('namespace', 'n', '__ns', '/x')),
        ('__ns:=/', RemapRule('namespace', None, '__ns', '/')),
        ('~/a:=/b/c', RemapRule('any', None, '~/a', '/b/c')),
    ],
)
def test_remap_rules(text: str, rule: RemapRule) -> None:
    assert parsed('-r', text).remap_rules == [rule]


REMAP, PARAMETER = (
    "Couldn't parse remap rule: '-r {0}'. Error: {1}",
    "Couldn't parse parameter override rule: '-p {0}'. Error: {1}",
)


@pytest.mark.parametrize(
    ('arguments', 'text'),
    [
        (['-r', rule], REMAP.format(rule, reason))
        for rule, reason in (
            ('x', 'Expected lexeme type (19) not found, search ended at index 1'),
            ('/n:x:=y', 'Expected lexeme type 19, got 5 at index 2'),
            (':=x', 'Expecting token or wildcard'),
            ('x:=y z', 'Expected lexeme type (19) not found, search ended at index 4'),
            ('x:=1', 'error not set'),
            ('a__b:=x', 'Expected lexeme type 19, got 18 at index 2'),
            ('/*:=x', "Wildcard '*' is not implemented"),
            (r'x:=\1', 'Backreferences are not implemented'),
            (r'x:=y\2', 'Expected lexeme type 19, got 10 at index 4'),
            ('__node:=1', 'Expected lexeme type (18) not found, search ended at index 8'),
            ('__node:=a/b', 'Expected lexeme type 1, got 19 at index 9'),
            ('__ns:=g', 'Expected lexeme type 19, got 18 at index 6'),
            ('__ns:=/a//b', 'Expected lexeme type 1, got 19 at index 9'),
        )
    ]
    + [
        (['-p', rule], PARAMETER.format(rule, reason))
        for rule, reason in (
            ('x=1', 'Expected lexeme type (22) not found, search ended at index 1'),
            ('x', 'Expected lexeme type (22) not found, search ended at index 1'),
            ('/n:x:=1', 'Expected lexeme type 22, got 5 at index 2'),
            ('a..b:=1', 'Expecting token or wildcard'),
            ('x-y:=1', 'Expected lexeme type (22) not found, search ended at index 1'),
            ('__x:=1', 'Expecting token or wildcard'),
            ('x:=[1, a]', "Sequence should be of same type. Value type 'string' do not belong at line_num 1"),
        )
    ]
    + [
        (['-r'], "Couldn't parse trailing -r flag. No remap rule found."),
        (['-p'], "Couldn't parse trailing -p flag. No parameter override rule found."),
        (['--log-level'], "Couldn't parse trailing log level flag: '--log-level'. No log level provided."),
        (
            ['--log-level', 'loud'],
            "Couldn't parse log level: '--log-level loud'. Error: Argument does not use a valid severity level",
        ),
        (
            ['--log-level', ':=info'],
            "Couldn't parse log level: '--log-level :=info'. Error: Argument has an invalid logger item that name is empty",
        ),
        (
            ['--log-level', 'n:='],
            "Couldn't parse log level: '--log-level n:='. Error: Expected lexeme type (18) not found, search ended at index 3",
        ),
    ],
)
def test_refused_arguments(arguments: list[str], text: str) -> None:
    with pytest.raises(RosArgumentsError) as caught:
        parsed(*arguments)
    assert str(caught.value).split('\n')[0] == text


@pytest.mark.parametrize('name', ['a.b', '/a', 'a__b', 'a/b', '//a', 'qos_overrides./t.publisher.depth'])
def test_parameter_names(name: str) -> None:
    assert values(parsed('-p', f'{name}:=1'), '/n') == {name: 1}


def test_a_remap_rule_outside_of_a_section_counts_and_is_deprecated() -> None:
    result = parse_ros_arguments(['prog', 'a:=b', '1:=2', '--ros-args', '-r', 'c:=d'])
    assert ([rule.match for rule in result.remap_rules], result.deprecated, result.others) == (
        ['a', 'c'],
        ['a:=b'],
        ['prog', '1:=2'],
    )


def test_a_missing_parameter_file_is_refused() -> None:
    with pytest.raises(
        RosArgumentsError, match="Couldn't parse params file: '--params-file /no'. Error: Error opening YAML file"
    ):
        parse_ros_arguments(['--ros-args', '--params-file', '/no'])


@pytest.mark.parametrize(('name', 'near'), [('sea.yml', 'sea.yaml'), ('zebra.txt', None), ('nowhere/sea.yaml', None)])
@pytest.mark.parametrize('is_absolute', [True, False])
def test_the_file_of_the_nearest_name_in_its_folder_is_a_fact(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, name: str, near: str | None, is_absolute: bool
) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / 'sea.yaml').write_text('')
    path = str(tmp_path / name) if is_absolute else name
    with pytest.raises(RosArgumentsError) as refused:
        parse_ros_arguments(['--ros-args', '--params-file', path])
    facts = facts_of(refused.value)
    assert (facts['wanted'], facts['near']) == (path, near)


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


def test_a_pattern_with_and_without_a_slash_are_two() -> None:
    """As rcl has it: each counts from its own first appearance."""
    both = '/**:\n  ros__parameters:\n    r: 0\nsim:\n  ros__parameters:\n    r: 1\n'
    words = '--params-file', 'first', '--params-file', 'both'
    assert values(parsed(*words, first=FILE, both=both), '/sim') == {'r': 1}
    assert values(parsed(*words, first=FILE.replace('/sim', 'sim'), both=both), '/sim') == {'r': 0}


def test_values_know_where_they_came_from() -> None:
    result = parsed('--params-file', 'f', '-p', 'n:x:=off', f=FILE)
    assert result.overrides_for('/sim')['r'].origin == 'f line 3'
    assert result.overrides_for('/n')['x'] == (False, 'command line')


def test_levels_and_switches() -> None:
    result = parsed('--log-level', 'DEBUG', '--log-level', 'a.b:=warn', '--disable-stdout-logs', '--enable-rosout-logs')
    assert (result.log_levels, result.outputs) == ({'': 10, 'a.b': 30}, {'stdout': False, 'rosout': True})


def test_plain_rules_read_at_one_look_are_what_the_reader_reads_lexeme_by_lexeme(monkeypatch: pytest.MonkeyPatch) -> None:
    parts = ['a', 'a', 'b1', 'cd', *'_/:*1.', '__', '__node', '__name', '__ns', '~/', ':=', 'rostopic://', '\\1', 'x_y_']
    choose = random.Random(7)
    texts = [''.join(choose.choices(parts, k=choose.randint(1, 2))) for _ in range(3000)]
    rules = [f'{old}:={new}' for old, new in zip(texts, reversed(texts), strict=True)]

    def read(text: str) -> object:
        try:
            return ros_arguments.remap_rule(text)
        except ros_arguments.RuleError as error:
            return str(error)

    quickly = [read(rule) for rule in rules]
    monkeypatch.setattr(ros_arguments, '_PLAIN_RULE', re.compile('(?!)'))
    assert quickly == [read(rule) for rule in rules]
    assert sum(isinstance(rule, RemapRule) for rule in quickly) > 100


@pytest.mark.parametrize(
    ('texts', 'value'),
    [
        (['a:=off', 'a:=2'], False),
        (['a:=2', 'a:=off'], False),
        (['a:=2.5', 'a:=1'], 1),
        (['a:=1', 'a:=x'], 1),
        (['a:=1', 'a:=3'], 3),
        (['a:=[1,2]', 'a:=x'], 'x'),
        (['a:=[x]', 'a:=[1]'], [1]),
        (['m:a:=x', 'a:=1'], 1),
        (['a:=1', 'm:a:=x'], 'x'),
    ],
)
def test_of_several_values_the_type_decides_before_the_order_as_with_the_real_rclpy(texts: list[str], value: object) -> None:
    parsed = parse_ros_arguments(['--ros-args', *(word for text in texts for word in ('-p', text))])
    assert parsed.overrides_for('/m')['a'].value == value
