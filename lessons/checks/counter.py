"""The check of lesson 0, your turn: an object that counts, and a function that calls its argument."""

from __future__ import annotations

from typing import Any

from edugrade import Evidence, Rubric, check
from edugrade.library.called import call, defined


@check(points=1)
def counter_counts(run: Evidence) -> None:
    """Counter('hits').on_message() returns hits: 1, then hits: 2"""
    counter = call('Counter', defined(run, 'Counter'), 'hits')
    for expected in ('hits: 1', 'hits: 2'):
        call('on_message', getattr(counter, 'on_message', None), wanted=expected)


@check(points=1)
def each_counter_counts_for_itself(run: Evidence) -> None:
    """Each counter has its own count and its own name"""
    first, second = (call('Counter', defined(run, 'Counter'), name) for name in ('hits', 'laps'))
    call('on_message', getattr(first, 'on_message', None))
    call('on_message', getattr(second, 'on_message', None), wanted='laps: 1')


@check(points=1)
def three_calls_three_times(run: Evidence) -> None:
    """three(callback) calls the function three times, and returns the results as a list"""
    calls: list[int] = []

    def callback() -> Any:
        calls.append(len(calls) + 1)
        return calls[-1] * 10

    call('three', defined(run, 'three'), callback, wanted=[10, 20, 30])


RUBRIC = Rubric(
    title='A counter, and three calls',
    names=['Counter', 'three'],
    checks=[counter_counts, each_counter_counts_for_itself, three_calls_three_times],
)
