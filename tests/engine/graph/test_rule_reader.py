"""How remapping and parameter rules of a command line are read."""

from __future__ import annotations

import re
from collections.abc import Callable

import pytest

from edulaunch.engine.graph.rule_reader import (
    RuleError,
    RuleReader,
    read_matched_name,
    read_new_name,
    read_new_namespace,
    read_parameter_name,
)


@pytest.mark.parametrize(
    ('text', 'kinds'),
    [
        ('a/b.c', [18, 19, 18, 22, 18]),
        ('~/a:=/b', [2, 18, 8, 19, 18]),
        ('rosservice://a', [3, 18]),
        ('rostopic:///a', [4, 19, 18]),
        ('n:__ns:=/x', [18, 5, 7, 8, 19, 18]),
        ('__node:=a', [6, 8, 18]),
        ('__name:=a', [6, 8, 18]),
        ('/**/*', [19, 21, 19, 20]),
        (r'\1\9', [9, 17]),
        ('_a1_b_', [18]),
        ('', []),
    ],
)
def test_the_parts_of_a_rule_have_the_numbers_of_rcl(text: str, kinds: list[int]) -> None:
    reader, found, taken = RuleReader(text), [], ''
    while reader.kind != 1:
        found.append(reader.kind)
        taken += reader.take()
    assert (found, taken, reader.position) == (kinds, text, len(text))


@pytest.mark.parametrize('text', ['1a', '-', ' ', r'\0', '__x'])
def test_other_letters_are_nothing(text: str) -> None:
    assert RuleReader(text).kind == 0


def test_a_name_may_be_for_one_node() -> None:
    reader = RuleReader('n:a:=b')
    assert (reader.node_prefix(), reader.position, reader.node_prefix()) == ('n', 2, None)
    assert (RuleReader('n:=a').node_prefix(), RuleReader('/n:a:=b').node_prefix()) == (None, None)


@pytest.mark.parametrize(
    ('text', 'kind', 'problem'),
    [
        ('a', 19, 'Expected lexeme type 19, got 18 at index 0'),
        ('', 19, 'Expected lexeme type (19) not found, search ended at index 0'),
        ('-', 18, 'Expected lexeme type (18) not found, search ended at index 0'),
    ],
)
def test_another_part_than_expected_is_named(text: str, kind: int, problem: str) -> None:
    with pytest.raises(RuleError, match=f'^{re.escape(problem)}$'):
        RuleReader(text).expect(kind)
    assert RuleReader('/').expect(19) == '/'


READ: dict[str, Callable[[RuleReader], str]] = {
    'matched': read_matched_name,
    'new': read_new_name,
    'namespace': read_new_namespace,
    'parameter': read_parameter_name,
}


@pytest.mark.parametrize(
    ('how', 'text', 'name', 'rest'),
    [
        ('matched', 'a:=b', 'a', 'b'),
        ('matched', '/a/b:=c', '/a/b', 'c'),
        ('matched', '~/a:=c', '~/a', 'c'),
        ('new', '/a/b', '/a/b', '/a/b'),
        ('new', '~/a', '~/a', '~/a'),
        ('new', 'a', 'a', 'a'),
        ('namespace', '/', '/', None),
        ('namespace', '/a/b', '/a/b', None),
        ('namespace', '/a/b/', '/a/b/', None),
        ('parameter', 'a.b/c:=1', 'a.b/c', '1'),
        ('parameter', 'a:=1', 'a', '1'),
    ],
)
def test_names(how: str, text: str, name: str, rest: str | None) -> None:
    reader = RuleReader(text)
    assert READ[how](reader) == name
    if how in ('matched', 'parameter'):
        assert text[reader.position :] == rest


@pytest.mark.parametrize(
    ('how', 'text', 'problem'),
    [
        ('matched', '*:=a', "Wildcard '*' is not implemented"),
        ('matched', 'a/**:=a', "Wildcard '**' is not implemented"),
        ('matched', '/:=a', 'Expecting token or wildcard'),
        ('matched', 'a.b:=c', 'Expected lexeme type 19, got 22 at index 1'),
        ('matched', 'a', 'Expected lexeme type (19) not found, search ended at index 1'),
        ('new', r'\1', 'Backreferences are not implemented'),
        ('new', r'a/\9', 'Backreferences are not implemented'),
        ('new', '', 'error not set'),
        ('new', 'a/', 'error not set'),
        ('new', 'a*', 'Expected lexeme type 19, got 20 at index 1'),
        ('namespace', 'a', 'Expected lexeme type 19, got 18 at index 0'),
        ('namespace', '/a.b', 'Expected lexeme type 1, got 22 at index 2'),
        ('parameter', 'a.*:=1', "Wildcard '*' is not implemented"),
        ('parameter', ':=1', 'Expecting token or wildcard'),
        ('parameter', 'a', 'Expected lexeme type (22) not found, search ended at index 1'),
        ('parameter', 'a..b:=1', 'Expecting token or wildcard'),
    ],
)
def test_wrong_names_have_rcls_reason(how: str, text: str, problem: str) -> None:
    with pytest.raises(RuleError, match=f'^{re.escape(problem)}$'):
        READ[how](RuleReader(text))
