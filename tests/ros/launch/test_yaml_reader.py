"""YAML of launch and parameter files: values, lines, and what is refused because it is too deep or grows."""

from __future__ import annotations

from typing import Any

import pytest
import yaml
from launch.utilities.yaml_reader import LONGEST_READ_TWICE, MAX_DEPTH, SAFE_DEPTH, Mapping, read, read_file


@pytest.mark.parametrize(
    'text',
    [
        '',
        '# nothing',
        'a',
        '1',
        'true',
        '~',
        '2020-01-01',
        '[1, [a, 2.5], {b: null}]',
        'a: 1\nb:\n  - x\n  - y: 0x10\n',
        '&x [1, *x2]',
    ],
)
def test_values_are_those_of_yaml(text: str) -> None:
    if 'x2' in text:
        with pytest.raises(yaml.YAMLError, match='undefined alias'):
            read(text)
    else:
        assert read(text) == yaml.safe_load(text)


def test_mappings_know_their_lines() -> None:
    found = read('\na:\n  b: 1\n  c:\n    d: {e: 2}\n')
    assert isinstance(found, Mapping)
    assert [one.line for one in (found, found['a'], found['a']['c'], found['a']['c']['d'])] == [2, 3, 5, 5]


def test_merged_keys_are_there() -> None:
    assert read('base: &b {x: 1, y: 2}\nother: {<<: *b, y: 3}\n')['other'] == {'x': 1, 'y': 3}


def test_a_key_must_be_hashable() -> None:
    with pytest.raises(yaml.YAMLError, match='found unhashable key'):
        read('? [a]\n: 1\n')


def lists(depth: int) -> str:
    return '[' * depth + ']' * depth


@pytest.mark.parametrize(
    'text',
    [lists(MAX_DEPTH), '\n'.join(f'{" " * level}a:' for level in range(MAX_DEPTH - 1)), 'x' * 5000, '"' + '[' * 2000 + '"'],
)
def test_as_deep_as_allowed(text: str) -> None:
    assert read(text) == yaml.safe_load(text)


@pytest.mark.parametrize(
    ('text', 'line'),
    [
        (lists(MAX_DEPTH + 1), 1),
        ('\n\n' + lists(SAFE_DEPTH + 500), 3),
        ('a: 1\nb: ' + '{a: ' * 150 + '1' + '}' * 150, 2),
        ('\n'.join(f'{" " * level}a:' for level in range(MAX_DEPTH)) + ' {b: {c: 1}}', MAX_DEPTH),
        ('\n'.join('[' for _ in range(SAFE_DEPTH + 500)), MAX_DEPTH + 1),
    ],
)
def test_what_is_too_deep_is_refused_with_its_line(text: str, line: int) -> None:
    with pytest.raises(ValueError, match='nested more than 100 levels deep') as caught:
        read(text)
    assert caught.value.edulaunch_line == line  # type: ignore[attr-defined]


def test_many_brackets_beside_each_other_are_not_deep() -> None:
    text = '\n'.join('- [[[[1]]]]' for _ in range(400)) + '\n' + '\n'.join('- [\'[\', "["] # [' for _ in range(400))
    assert read(text) == yaml.safe_load(text)


def test_aliases_may_repeat_but_not_multiply() -> None:
    assert read('a: &x [1, 2]\nb: [*x, *x]')['b'] == [[1, 2], [1, 2]]
    rows = ['a0: &a0 [x, x, x, x, x, x, x, x, x, x]']
    rows += [f'a{n}: &a{n} [{", ".join([f"*a{n - 1}"] * 10)}]' for n in range(1, 9)]
    with pytest.raises(ValueError, match='aliases multiply the text to more than') as caught:
        read('\n'.join(rows))
    assert 1 <= caught.value.edulaunch_line <= 9  # type: ignore[attr-defined]


def test_an_alias_inside_of_itself_is_too_deep() -> None:
    with pytest.raises(ValueError, match='nested more than'):
        read('a: &a\n  b: *a\n')


def test_an_error_names_the_file_and_a_tab_has_its_own_advice() -> None:
    with pytest.raises(yaml.YAMLError, match='in "robot.yaml", line 2') as caught:
        read_file('a: 1\n\tb: 2\n', 'robot.yaml')
    assert caught.value.edulaunch_facts['about'] == 'launch.yaml-tab'  # type: ignore[attr-defined]
    with pytest.raises(yaml.YAMLError, match='in "robot.yaml"') as other:
        read_file('a: [1\n', 'robot.yaml')
    assert not hasattr(other.value, 'edulaunch_facts')
    assert read_file('a: 1', 'robot.yaml') == {'a': 1}


def test_a_long_file_is_read_once() -> None:
    long: Any = 'a: [1\n' + '# x' * LONGEST_READ_TWICE
    with pytest.raises(yaml.YAMLError) as caught:
        read_file(long, 'robot.yaml')
    assert 'robot.yaml' not in str(caught.value)
