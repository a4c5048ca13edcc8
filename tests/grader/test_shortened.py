"""Texts are cut between words, and patterns are read aloud."""

from __future__ import annotations

import pytest
from edugrade.shortened import last_lines, readable, shortened


@pytest.mark.parametrize(
    ('text', 'most', 'wanted'),
    [
        ('one two three', 20, 'one two three'),
        ('one two three', 13, 'one two three'),
        ('one two three', 9, 'one two'),
        ('a bcd', 3, 'a'),
        ('one two three', 7, 'one'),
        ('abcdef', 3, 'abc'),
    ],
)
def test_a_text_is_cut_between_words(text: str, most: int, wanted: str) -> None:
    assert shortened(text, most) == wanted


def test_the_last_lines_are_whole() -> None:
    assert last_lines(['a\nb', 'c\n\nd\n'], 2) == 'bc\nd'
    assert last_lines(['word ' * 100], most=12) == 'word word ...'
    assert last_lines([]) == ''


@pytest.mark.parametrize(
    ('pattern', 'wanted'),
    [
        (r'messages: 10$', 'messages: 10'),
        (r'^now: -?\d+\.\d+ -?\d+\.\d+$', 'now: NUMBER NUMBER'),
        (r'newest: (\d+\.\d\d) (\d+\.\d\d), (\d\.\d\d) s old', 'newest: NUMBER NUMBER, NUMBER s old'),
        (r'messages: (\d+)$', 'messages: NUMBER'),
        (r'^count: [0-9]+\b', 'count: NUMBER'),
        (r'the (?:red|blue) one', 'the red or blue one'),
        (r'at [a-z_]{3,} \d{2}', 'at WORD NUMBER'),
    ],
)
def test_a_pattern_is_shown_as_text(pattern: str, wanted: str) -> None:
    assert readable(pattern) == wanted
