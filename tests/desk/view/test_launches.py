"""What is shown of launches that a recording of a stranger brings."""

from __future__ import annotations

from typing import Any

import pytest

from edulaunch.desk.view.launches import in_microseconds, launches_of

STEP = {'number': 1, 'parent': 0, 'order': 1, 'time': 0, 'state': 'taken', 'kind': 'log', 'text': 'x', 'details': []}
LAUNCH = {'pid': 1, 'at': None, 'count': 2}
ORIGIN = {'value': 1, 'origin': 'default', 'file': None, 'line': None, 'counts': True, 'argument': []}


def rows(**other: Any) -> list[Any]:
    return [launch['rows'] for launch in launches_of([{**LAUNCH, 'rows': [{**STEP, **other}]}])]


def test_a_launch_as_it_should_be_is_shown() -> None:
    value = {'kind': 'argument', 'name': 'a', 'value': [1], 'chain': [{**ORIGIN, 'argument': [ORIGIN]}]}
    assert rows(values=[value]) == [[{**STEP, 'values': [value]}]]


@pytest.mark.parametrize(
    'other',
    [
        {'number': '1'},
        {'state': '<b>'},
        {'text': ['x']},
        {'details': [['a', 'b']]},
        {'runs': [[1, 2]]},
        {'changes': {'configurations': 3}},
        {'surprise': 1},
        {'values': [{'kind': 'argument', 'name': 'a', 'value': 1, 'chain': [{'value': 1}]}]},
    ],
)
def test_what_is_not_as_it_should_be_is_not_shown(other: dict[str, Any]) -> None:
    assert rows(**other) == []


def test_a_step_below_itself_is_left_out() -> None:
    assert rows(parent=1) == [[]]
    assert rows(parent=-2) == [[]]


def test_a_chain_without_end_is_refused() -> None:
    chain: list[Any] = []
    for _ in range(100):
        chain = [{**ORIGIN, 'argument': chain}]
    assert rows(values=[{'kind': 'argument', 'name': 'a', 'value': 1, 'chain': chain}]) == []


@pytest.mark.parametrize('told', [None, 3, 'x', [3], {'pid': 1}])
def test_anything_else_shows_nothing(told: Any) -> None:
    assert list(launches_of(told)) == []


def test_times_are_microseconds() -> None:
    step = {**STEP, 'time': 2000, 'due': 3000, 'fired_at': [4000], 'runs': [[7, 1000, None, None], [8, 1000, 2000, 0]]}
    row = in_microseconds({**LAUNCH, 'rows': [step]})['rows'][0]
    assert (row['time'], row['due'], row['fired_at'], row['runs']) == (2, 3, [4], [[7, 1, None, None], [8, 1, 2, 0]])
