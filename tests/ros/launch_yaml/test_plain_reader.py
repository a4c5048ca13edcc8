"""The quick reader says what libyaml says, or nothing."""

from __future__ import annotations

import pytest
import yaml
from hypothesis import given, settings
from hypothesis import strategies as st
from launch.utilities.yaml_reader import read
from launch_yaml.plain_reader import NotPlain, read_plain

from tests.house import EXAMPLES

PIECES = (
    '- ',
    '-',
    ' ',
    '  ',
    '\n',
    '\n',
    '\n',
    'node:',
    'key: ',
    'a',
    'x y',
    '1',
    '007',
    '-1.5',
    'true',
    'on',
    'null',
    '# c',
    ':',
    '{',
    '}',
    '{a: b}',
    '{a: 1, b: "q, r"}',
    "{a: 1, b: 'q'}",
    '{a: 1,b: 2}',
    '{a: x, }',
    '{a:  b}',
    '{on: 1}',
    '{a: 1, a: 2}',
    '{a: $(var x)}',
    '"s"',
    "'t'",
    'name:',
    'list:',
    ', ',
    'b: ',
)


def lines(value):
    """The line of each mapping in a value."""
    if isinstance(value, dict):
        return [value.line, [lines(item) for item in value.values()]]
    return [lines(item) for item in value] if isinstance(value, list) else None


@settings(max_examples=5 * EXAMPLES)
@given(st.lists(st.sampled_from(PIECES), max_size=14).map(''.join))
def test_both_read_the_same(text):
    try:
        plain = read_plain(text)
    except NotPlain:
        return
    slow = read(text)
    assert repr(plain) == repr(slow)
    assert lines(plain) == lines(slow)


@pytest.mark.parametrize(
    'text',
    [
        'launch:\n- node:\n    pkg: a\n    param:\n    - {name: x, value: 1}\n    - {name: z, value: "a, b"}\n',
        '# a comment\n\na: true\nb:\n  - 1\n  - two words\n',
    ],
)
def test_usual_files_are_plain(text):
    assert read_plain(text) == yaml.safe_load(text)


@pytest.mark.parametrize(
    'text', ['a: {b: 1', 'a: {b: 1,c: 2}', 'a: {b: 1} # c', 'a: {y: 1}', 'a: {b}', 'a: {}', 'a: {b: {c: 1}}', 'a: {b: }']
)
def test_what_is_not_certain_is_left_to_libyaml(text):
    with pytest.raises(NotPlain):
        read_plain(text)
