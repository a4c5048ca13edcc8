"""Comparing and filtering texts; parameters and markers."""

from __future__ import annotations

import re
from typing import Any

import launch_testing
import pytest
from launch_testing.markers import keep_alive, retry_on_failure
from launch_testing.tools import basic_output_filter, build_text_match, expect_output


@pytest.mark.parametrize(
    ('arguments', 'answer'),
    [
        ({'expected_text': 'b', 'text': 'abc'}, True),
        ({'expected_text': 'b', 'text': 'abc', 'strict': True}, False),
        ({'expected_text': re.compile('a.c'), 'text': 'abc', 'strict': True}, True),
        ({'expected_lines': ['a', re.compile('c+')], 'text': 'a\nb\nccc\n'}, True),
        ({'expected_lines': ['c', 'a'], 'text': 'a\nb\nc\n'}, False),
        ({'expected_lines': ['a', 'b'], 'lines': ['a\n', 'b\n'], 'strict': True}, True),
        ({'expected_lines': ['a'], 'lines': ['a', 'b'], 'strict': True}, False),
    ],
)
def test_expected_output(arguments: dict[str, Any], answer: bool) -> None:
    assert expect_output(**arguments) is answer


def test_expectations_must_be_unambiguous() -> None:
    with pytest.raises(ValueError, match="Either 'expected_text' or 'expected_lines'"):
        expect_output(text='a')
    with pytest.raises(ValueError, match="Either 'text' or 'lines'"):
        expect_output(expected_text='a')


def test_a_match_says_where_it_is() -> None:
    match = build_text_match(['a', re.compile('c')])
    assert match('xabc') == (1, 4)
    assert match('xabcabc', 3) == (4, 7)
    with pytest.raises(ValueError, match='Unknown format for expected text: expected a text or a compiled .* got int: 3'):
        build_text_match(3)


def test_filters_leave_lines_out() -> None:
    wanted = basic_output_filter(filtered_prefixes=['[INFO]'], filtered_patterns=['.*noise'])
    assert wanted('[INFO] a\nb\nsome noise\nc') == 'b\nc'


def test_parametrize_accepts_names_and_values_of_all_kinds() -> None:
    @launch_testing.parametrize('a', [1, (2,), 'three', [4, 5]])
    def one(a: object) -> object:
        return a

    assert [(function(), row) for function, row in one()] == [
        (1, {'a': 1}),
        (2, {'a': 2}),
        ('three', {'a': 'three'}),
        ([4, 5], {'a': [4, 5]}),
    ]
    with pytest.raises(ValueError, match=r"parametrize: 2 names \['a', 'b'\], but 3 values"):
        launch_testing.parametrize('a,b', [(1, 2, 3)])


def test_retry_on_failure_counts_the_last() -> None:
    tries: list[int] = []

    @retry_on_failure(times=3)
    def flaky() -> int:
        tries.append(1)
        assert len(tries) > 2
        return len(tries)

    assert flaky() == 3
    with pytest.raises(ValueError, match='at least 1, got 0'):
        retry_on_failure(times=0)


def test_markers_add_up() -> None:
    @keep_alive
    @launch_testing.ready_to_test_action_timeout(3)
    def description() -> None: ...

    assert description.__markers__ == {'keep_alive': True}  # type: ignore[attr-defined]
    assert description.__ready_to_test_action_timeout__ == 3  # type: ignore[attr-defined]


def test_every_exported_name_is_there() -> None:
    for module in (launch_testing, launch_testing.actions, launch_testing.asserts, launch_testing.tools, launch_testing.util):
        for name in module.__all__:
            assert getattr(module, name) is not None
