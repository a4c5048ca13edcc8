"""Which checks run, and what becomes of those that do not."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import pytest
from edugrade import Check, Evidence, Failure, Scenario, check
from edugrade.judging import judge
from edugrade.outcome import Outcome
from edugrade.results import CheckResult
from edugrade.source import Source

ONE = Scenario('one', {'radius': '0.5'})
TWO = Scenario('two', {'radius': '1.0'})
RECORDING: Any = SimpleNamespace(advice=[])
SOURCE = Source('a.launch.py', '')


@check(points=1)
def good(run: Evidence) -> None:
    """Good"""


@check(points=2)
def bad(run: Evidence) -> None:
    """Bad"""
    raise Failure('it is bad', expected=1, seen=2, where=('a.launch.py', 3), try_='do good')


@check(points=4, needs=[good, bad])
def child(run: Evidence) -> None:
    """Child"""


@check(points=8, needs=[child])
def grandchild(run: Evidence) -> None:
    """Grandchild"""


@check(points=16)
def faulty(run: Evidence) -> None:
    """Faulty"""
    raise ZeroDivisionError('our mistake')


def judged(checks: list[Check], *outcomes: Outcome) -> dict[str, CheckResult]:
    recorded = Outcome(ONE, 'recorded', recording=RECORDING)
    return {result.name: result for result in judge(checks, outcomes or [recorded], SOURCE)}


def test_a_failure_becomes_a_result_with_everything_it_says() -> None:
    result = judged([bad])['bad']
    assert (result.status, result.earned, result.reason, result.expected, result.seen) == ('failed', 0, 'it is bad', '1', '2')
    assert result.where == ('a.launch.py', 3)
    assert result.try_ == 'do good'


def test_what_needs_a_failed_check_is_not_run_and_names_the_first_cause() -> None:
    results = judged([good, bad, child, grandchild])
    assert [results[name].status for name in ('good', 'bad', 'child', 'grandchild')] == ['passed', 'failed', 'not_run', 'not_run']
    assert results['child'].root_cause == results['grandchild'].root_cause == 'bad'
    assert results['grandchild'].reason == 'because "Bad" failed'


def test_a_check_that_breaks_is_the_graders_fault() -> None:
    result = judged([faulty])['faulty']
    assert result.status == 'grader_broke'
    assert 'ZeroDivisionError: our mistake' in result.reason


def test_without_a_recording_no_check_is_run() -> None:
    results = judged([good, child.needs[1]], Outcome(ONE, 'unusable', text='no such package'))
    assert [result.status for result in results.values()] == ['failed', 'not_run', 'not_run']
    assert results['launches'].reason == 'no such package'
    assert results['good'].root_cause == 'launches'


def test_a_run_that_fails_with_one_argument_only_says_so() -> None:
    results = judged([good], Outcome(ONE, 'recorded', recording=RECORDING), Outcome(TWO, 'stopped', text='too slow'))
    assert results['launches'].seen == 'only when launched with radius:=1.0'
    assert results['good'].status == 'not_run'


def test_a_broken_engine_goes_before_a_students_mistake() -> None:
    results = judged([good], Outcome(ONE, 'unusable', text='x'), Outcome(TWO, 'broke', text='engine'))
    assert results['launches'].status == 'grader_broke'
    assert results['good'].reason.endswith('broke')


def test_a_check_that_looks_too_long_fails_and_the_others_are_judged(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr('edugrade.judging.LONGEST_CHECK_S', 0.05)

    @check(points=1)
    def slow(run: Evidence) -> None:
        """It is looked at"""
        while True:
            pass

    @check(points=1)
    def quick(run: Evidence) -> None:
        """It is there"""

    results = judge([slow, quick], [Outcome(Scenario('a'), 'recorded', RECORDING)], SOURCE)
    assert [(result.status, result.earned) for result in results[1:]] == [('failed', 0), ('passed', 1)]
    assert 'cannot be looked at' in results[1].reason
