"""edulaunch.engine.graph.parameter_files."""

from __future__ import annotations

from typing import Any

import pytest

from edulaunch.engine.facts import facts_of
from edulaunch.engine.graph.parameter_files import Entry, ParameterFileError, read_parameter_file, read_value


def test_patterns_nested_namespaces_and_dotted_names() -> None:
    text = (
        '/**:\n  ros__parameters:\n    rate: 5\n'
        'ns:\n  sim:\n    ros__parameters:\n      color:\n        r: 1.5\n      names: [a, "5"]\n'
    )
    assert read_parameter_file(text) == [
        Entry('/**', 'rate', 5, 3),
        Entry('ns/sim', 'color.r', 1.5, 8),
        Entry('ns/sim', 'names', ['a', '5'], 9),
    ]


def test_an_empty_file_has_no_parameters() -> None:
    assert read_parameter_file('') == []


@pytest.mark.parametrize(
    ('text', 'reason'),
    [
        ('sim: 5\n', 'Cannot have a value before ros__parameters at line 1'),
        ('ros__parameters:\n  a: 1\n', 'There are no node names before ros__parameters at line 1'),
        (
            'n:\n  ros__parameters:\n    a: [1, 2.0]\n',
            "Sequence should be of same type. Value type 'double' do not belong at line_num 3",
        ),
        ('n:\n  ros__parameters:\n    a:\n', 'No value at line 3'),
        ('n:\n  ros__parameters:\n    a: &x 1\n    b: *x\n', 'Will not support aliasing at line 4'),
        ('n:\n  ros__parameters:\n    a: [[1], [2]]\n', 'Sequences cannot be values of a sequence. Error at line 3'),
        ('n:\n  ros__parameters:\n    a: [1, 2\n', 'Error parsing a event near line 3'),
    ],
)
def test_what_rcl_refuses_is_refused_with_its_line(text: str, reason: str) -> None:
    with pytest.raises(ParameterFileError) as caught:
        read_parameter_file(text)
    assert str(caught.value).startswith(reason)


@pytest.mark.parametrize(
    ('text', 'facts'),
    [
        ('n:\n  ros_parameters:\n    a: 1\n', {'about': 'launch.parameters-key', 'found': 'ros_parameters', 'at': 3}),
        ('n:\n  a: 1\n', {'about': 'launch.parameter-file'}),
        (
            'n:\n  ros__parameters:\n\ta: 1\n',
            {'about': 'launch.yaml', 'at': 3, 'problem': 'found character that cannot start any token'},
        ),
        ('n:\n  ros__parameters:\n    a: [1, 2.0]\n', {'about': 'launch.list-of-one-type', 'at': 3, 'word': None}),
        ('n:\n  ros__parameters:\n    a:\n', {'about': 'launch.no-value'}),
    ],
)
def test_common_mistakes_carry_facts(text: str, facts: dict[str, Any]) -> None:
    with pytest.raises(ParameterFileError) as caught:
        read_parameter_file(text)
    assert facts_of(caught.value) == facts


@pytest.mark.parametrize(
    ('text', 'value'),
    [
        ('5', 5),
        ('-5', -5),
        ('off', False),
        ("'5'", '5'),
        ('!!str off', 'off'),
        ('Hello world', 'Hello world'),
        ('[1, 2]', [1, 2]),
        ('[a, b]', ['a', 'b']),
        ('[]', None),
    ],
)
def test_values_of_the_command_line(text: str, value: Any) -> None:
    assert read_value(text) == value


def test_a_value_of_the_command_line_must_not_be_empty() -> None:
    with pytest.raises(ParameterFileError, match='error not set'):
        read_value('')


@pytest.mark.parametrize(
    ('text', 'reason'),
    [
        ('{b: 1}', 'Unknown YAML event'),
        ('*x', 'Unknown YAML event'),
        ('[1', 'Error parsing an event'),
        ('@', 'Error parsing an event'),
        ('>', 'No value at line 1'),
    ],
)
def test_a_value_alone_is_refused_in_words_of_its_own(text: str, reason: str) -> None:
    with pytest.raises(ParameterFileError) as caught:
        read_value(text)
    assert str(caught.value) == reason


def test_a_comment_is_no_value() -> None:
    assert read_value('# nothing') is None
