"""What the rules find in the runs stands at the check that it is about. Marks do not know of it."""

from __future__ import annotations

from typing import Any

import pytest
from edugrade.causes import with_causes
from edugrade.language import explained, retold
from edugrade.place import Place
from edugrade.results import FAILED, PASSED, CheckResult
from edugrade.short_paths import ShortPaths
from edugrade.steps import KIND, at_level

from edulaunch.advice import Finding, Reader, found


class Run:
    """A recording whose advice is known."""

    def __init__(self, *advice: Finding) -> None:
        self.advice = list(advice)


def evidence(*advice: Finding) -> Any:
    return {'first': Run(*advice), 'second': Run(*advice)}


def failed(name: str, **more: Any) -> CheckResult:
    return CheckResult(name, f'Sentence of {name}', FAILED, **more)


FRAME = found('frame', 'carot1', near='carrot1', nodes='/listener')._replace(rule='tf.unknown-frame')
SAME = found('node', '/talker', first='a', second='b', other='c', file='/x/a.launch.py', line=7)._replace(
    rule='programs.same-name'
)
DEAD = found('process', 'sim-1', code=1)._replace(rule='programs.died')


def test_a_finding_stands_at_the_check_that_names_it() -> None:
    checks = [failed('first'), failed('second', expected='the frame carrot1'), CheckResult('third', 'carrot1', PASSED)]
    assert [result.cause for result in with_causes(checks, evidence(SAME, FRAME))] == [None, FRAME, None]


def test_a_finding_stands_at_the_check_of_its_line() -> None:
    checks = [failed('first', where=Place('/x/a.launch.py', 6)), failed('second', where=Place('/x/a.launch.py', 7))]
    assert [result.cause for result in with_causes(checks, evidence(SAME))] == [None, SAME]


def test_the_worst_one_stands_at_the_weightiest_when_none_is_about_it() -> None:
    checks = [CheckResult('launches', 'x', PASSED), failed('first', points=1), failed('second', points=2)]
    assert [result.cause for result in with_causes(checks, evidence(SAME, FRAME))] == [None, None, FRAME]
    assert [result.cause for result in with_causes(checks, evidence(SAME, DEAD))] == [None, None, DEAD]


def test_a_death_that_a_check_tells_of_is_not_told_twice() -> None:
    checks = [failed('first', points=1, reason='the program sim-1 died with exit code 1'), failed('second', points=2)]
    assert [result.cause for result in with_causes(checks, evidence(DEAD))] == [None, None]


def test_on_the_first_level_a_cause_is_told_only_of_a_program_that_could_not_go_on() -> None:
    assert at_level(failed('first', cause=DEAD), KIND).cause is DEAD
    assert at_level(failed('first', cause=FRAME), KIND).cause is None


def test_who_passed_everything_costs_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    checks = [CheckResult('launches', 'x', PASSED)]
    assert with_causes(checks, {'first': None}) is checks  # type: ignore[dict-item]


def test_a_report_is_retold_in_german() -> None:
    result = failed(
        'first',
        reason='the frame laser is missing',
        seen='nothing of the kind',
        try_='look at the Node of broadcaster1',
        cause=FRAME,
    )
    german = Reader('de')
    told = retold(result, german)
    assert told.reason != result.reason and 'laser' in told.reason
    shown = explained(told, ShortPaths(''), german)
    assert list(shown) == ['gesehen', 'versuch', 'Ursache'] and 'carrot1' in shown['Ursache']
