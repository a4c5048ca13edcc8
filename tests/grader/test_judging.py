"""Which checks run, and what becomes of those that do not.

What the rules find in the runs stands at the check that it is about. Marks do not know of it.
"""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import pytest
from edugrade import Check, Evidence, Failure, Scenario, check
from edugrade.evidence import Outcome
from edugrade.judging import judge, with_causes
from edugrade.reports.wording import KIND, ShortPaths, at_level, explained, translated
from edugrade.results import FAILED, PASSED, CheckResult
from edugrade.source import Place, SubmittedText
from fake_recording import FakeRecording, circle_run, graded

from edulaunch.advice import Finding, Reader, found

ONE = Scenario('one', {'radius': '0.5'})
TWO = Scenario('two', {'radius': '1.0'})
RECORDING: Any = SimpleNamespace(advice=[])
SOURCE = SubmittedText('a.launch.py', '')


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
    assert results['launches'].seen == 'a failure in 1 of the 2 runs: with radius:=1.0'
    assert results['good'].status == 'not_run'


def test_a_broken_engine_goes_before_a_students_mistake() -> None:
    results = judged([good], Outcome(ONE, 'unusable', text='x'), Outcome(TWO, 'broke', text='engine'))
    assert results['launches'].status == 'grader_broke'
    assert results['good'].reason.startswith('because the grader failed in ')


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
    assert 'cannot judge the recording' in results[1].reason


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
    checks = [
        failed('first', where=Place('/x/a.launch.py', 7), reason='the frame is missing'),
        failed('second', where=Place('/x/a.launch.py', 7), reason='the node is silent'),
    ]
    assert [result.cause for result in with_causes(checks, evidence(SAME))] == [None, SAME]


def test_a_finding_that_explains_no_check_stands_nowhere() -> None:
    assert [result.cause for result in with_causes([failed('first', points=1)], evidence(SAME, FRAME))] == [None]


def test_a_finding_that_another_check_already_shows_better_stands_nowhere_else() -> None:
    other = FRAME._replace(name='carot_1')
    checks = [failed('weak', expected='a drive to carrot1'), failed('best', expected='the frame carrot1', seen='carot1, carot_1')]
    assert [result.cause for result in with_causes(checks, evidence(FRAME, other))] == [None, FRAME]


def test_a_finding_about_a_topic_of_a_turtle_stands_at_the_check_of_the_turtle() -> None:
    moved = found('topic', '/turtle1/cmd_vel', node='ros2-3', near='/first/turtle1/cmd_vel')._replace(rule='messages.other-topic')
    checks = [failed('other', reason='turtle2 does not move'), failed('own', reason='first/turtle1 does not drive a circle')]
    assert [result.cause for result in with_causes(checks, evidence(moved))] == [None, moved]


def test_a_finding_about_a_joint_stands_at_the_check_of_the_joint() -> None:
    wrong = found('topic', '/joint_states', node='ros2-2', joint='mast_jont', joints=['mast_joint'], near='mast_joint')
    wrong = wrong._replace(rule='messages.other-joint')
    checks = [failed('camera'), failed('mast', reason='no node publishes the angle of the joint')]
    assert [result.cause for result in with_causes(checks, evidence(wrong))] == [None, wrong]


def test_a_finding_that_only_repeats_the_check_is_left_out() -> None:
    absent = FRAME._replace(name='turtle2', facts={'near': None, 'nodes': '/listener'})
    assert with_causes([failed('only', reason='the frame turtle2 is missing')], evidence(absent))[0].cause is None


def test_a_finding_about_the_graders_own_node_is_left_out() -> None:
    visited = found('topic', '/blue/chatter', node='/visitor', near='/red/chatter')._replace(rule='messages.other-topic')
    assert with_causes([failed('only', expected='a subscription to /blue/chatter')], evidence(visited))[0].cause is None


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
    result = failed('first', reason='the frame laser is missing', seen='none', try_='check the Node of broadcaster1', cause=FRAME)
    german = Reader('de')
    result_in_german = translated(result, german)
    assert result_in_german.reason != result.reason and 'laser' in result_in_german.reason
    shown = explained(result_in_german, ShortPaths(''), german)
    assert list(shown) == ['gesehen', 'versuch', 'Ursache'] and 'carrot1' in shown['Ursache']


def test_a_rule_that_breaks_costs_no_mark() -> None:
    class Breaking(FakeRecording):
        def __getattribute__(self, name: str) -> Any:
            if name == 'advice':
                raise RuntimeError('a rule broke')
            return super().__getattribute__(name)

    results = graded('circle', lambda scenario: Breaking(**vars(circle_run(0.5))))
    assert results['radius_is_passed'].status == 'failed'
    assert results['radius_is_passed'].cause is None


def test_a_failure_that_another_one_explains_is_not_reported() -> None:
    @check(points=4, explained_by=[bad])
    def result_of_bad(run: Evidence) -> None:
        """It follows"""
        raise Failure('it does not follow')

    found = judged([good, bad, result_of_bad])['result_of_bad']
    assert (found.status, found.root_cause, found.earned) == ('not_run', 'bad', 0)
    assert judged([result_of_bad])['result_of_bad'].status == 'failed'


def test_a_finding_that_suggests_the_wrong_name_is_left_out() -> None:
    back = found('frame', 'base_link', near='baselink')._replace(rule='tf.unknown-frame')
    check_of_parent = failed('parent', expected='the parent base_link', seen='the parent baselink')
    assert [result.cause for result in with_causes([check_of_parent], evidence(back))] == [None]


def test_a_finding_stands_at_the_check_whose_advice_names_its_remapping() -> None:
    unused = found('node', '/mimic', old='/output/cmd_vels', near='output/cmd_vel')._replace(rule='launch.remapping-unused')
    checks = [failed('other'), failed('copies', try_='check the remappings of the Node of mimic')]
    assert [result.cause for result in with_causes(checks, evidence(unused))] == [None, unused]
