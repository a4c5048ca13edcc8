"""The report for people says everything in words."""

from __future__ import annotations

import re
from dataclasses import replace
from typing import Any

from edugrade import Scenario
from edugrade.evidence import Outcome
from edugrade.reports.terminal import MORE, render, sandbox_line
from edugrade.results import CheckResult
from edugrade.source import Gap
from made_report import BROKE, FAILED, FILE, NOT_RUN, PASSED, report

EXPECTED = """\
work/a.launch.py: A robot (rubric a, seed 7)

FAILED   It drives  [0 of 3]
         the robot stands
         expected: a circle
         seen:     no movement
         where:    work/a.launch.py:12
         try:      look at work/a.launch.py:12
not run  because "It drives" failed:
           It arrives  [0 of 4]
ok       It starts  [2 of 2]

1 of 3 checks passed: 2 of 9 points.
Next: make the check "It drives" pass, and grade the file again.
"""


def test_the_cause_comes_first_and_what_is_right_last() -> None:
    assert render(report(PASSED, FAILED, NOT_RUN)) == EXPECTED


def test_colour_adds_nothing_but_colour() -> None:
    coloured = render(report(PASSED, FAILED, NOT_RUN), colour=True)
    assert coloured != EXPECTED
    assert re.sub('\x1b\\[[0-9]*m', '', coloured) == EXPECTED


def test_the_next_step_follows_the_first_failure_and_open_gaps_are_listed() -> None:
    recording: Any = object()
    outcome = Outcome(Scenario('s'), 'recorded', recording=recording)
    text = render(report(FAILED, outcome=outcome, gaps=(Gap(FILE, 4, '# TODO 1: drive'),)))
    line = 'Next: make the check "It drives" pass, and grade the file again. Lines that still have a "# TODO" comment: 4'
    assert ' '.join(text.split()).endswith(line)


def test_an_open_gap_comes_after_a_file_that_cannot_run() -> None:
    unusable = Outcome(Scenario('s'), 'unusable')
    text = render(report(FAILED, outcome=unusable, gaps=(Gap(FILE, 4, '# TODO 1: drive'),)))
    assert text.endswith('Next: make the check "It drives" pass, and grade the file again.\n')


def test_failures_of_one_cause_are_one_block() -> None:
    second = replace(FAILED, name='b', sentence='It turns')
    other = replace(FAILED, name='c', sentence='It stops', seen='something else')
    lines = render(report(FAILED, second, other)).splitlines()
    assert lines[2:4] == ['FAILED   It drives  [0 of 3]', 'FAILED   It turns  [0 of 3]']
    assert [line.strip() for line in lines].count('the robot stands') == 2


def test_a_broken_grader_gives_no_mark() -> None:
    text = render(report(PASSED, BROKE))
    assert '1 of 2 checks passed: no mark, because the grader broke.' in text
    assert 'Next: show this report and the launch file to your teacher. This is not your mistake.' in text


def test_when_all_passed_the_next_step_is_the_next_exercise() -> None:
    assert render(report(PASSED)).splitlines()[-1].startswith('Next: start another exercise')


def test_long_texts_are_wrapped_under_their_label() -> None:
    lines = render(report(FAILED.__class__('a', 'A', 'failed', reason='word ' * 40, seen='thing ' * 40))).splitlines()
    assert max(map(len, lines)) <= 100
    assert [line for line in lines if 'thing' in line][1].startswith(' ' * 19 + 'thing')


def test_a_text_of_the_submission_cannot_repaint_the_report() -> None:
    text = render(report(CheckResult('a', 'A', 'failed', reason='\x1b[2Kok', seen='a\x07b')))
    assert '?[2Kok' in text
    assert 'seen:     a?b' in text


def test_a_run_that_did_not_begin_was_not_without_a_sandbox() -> None:
    broke = Outcome(Scenario('fast'), 'broke', sandbox=None)
    held = Outcome(Scenario('fast'), 'recorded', sandbox={'files': 'held'})
    assert sandbox_line([report(BROKE, outcome=broke)]) == 'sandbox: not needed. Nothing of the submission was run.'
    assert (
        sandbox_line([report(BROKE, outcome=broke), report(PASSED, outcome=held)])
        == 'sandbox: the submission had no access to the network, to other programs, or to files that it does not need.'
    )
    assert sandbox_line([report(PASSED)]).startswith('sandbox: off.')
    assert sandbox_line([]) == ''


def test_the_report_promises_better_advice_only_to_a_student_who_gets_it() -> None:
    shown = replace(report(replace(FAILED, try_='write a=b in the Node')), level=1)
    assert MORE not in render(shown)
    assert MORE in render(replace(shown, is_counted=True))
    assert MORE not in render(replace(shown, is_counted=True, level=3))


def test_the_line_on_the_sandbox_names_the_layers_that_failed() -> None:
    partly = Outcome(Scenario('fast'), 'recorded', sandbox={'files': 'held', 'network': 'no namespaces'})
    line = 'sandbox: these layers restricted the submission: files. These layers were MISSING: network (no namespaces).'
    assert sandbox_line([report(PASSED, outcome=partly)]) == line
