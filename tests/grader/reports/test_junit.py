"""The JUnit report is well-formed XML whatever a student wrote."""

from __future__ import annotations

from xml.etree import ElementTree

import pytest
from edugrade.reports.document import document
from edugrade.reports.junit import junit_text as text_of
from edugrade.results import CheckResult, Refusal, Report
from made_report import BROKE, FAILED, NOT_RUN, PASSED, report


def junit_text(reports: list[Report], refusals: list[Refusal]) -> str:
    return text_of([{'path': found.given, **document(found)} for found in reports], refusals)


NASTY = '<b>&"\x00\x1b]]>\ud800'


def test_a_suite_counts_and_a_case_says_what_happened() -> None:
    suite = ElementTree.fromstring(junit_text([report(PASSED, FAILED, NOT_RUN, BROKE)], []))[0]
    assert {key: suite.get(key) for key in ('tests', 'failures', 'errors', 'skipped')} == {
        'tests': '4',
        'failures': '1',
        'errors': '1',
        'skipped': '1',
    }
    cases = suite.findall('testcase')
    assert [[child.tag for child in case] for case in cases] == [[], ['failure'], ['skipped'], ['error']]
    assert cases[1][0].get('message') == 'the robot stands'
    assert cases[1][0].text == 'expected: a circle\nseen: no movement\nwhere: a.launch.py:12\ntry: look at a.launch.py:12'


def test_points_and_seed_are_properties() -> None:
    found = ElementTree.fromstring(junit_text([report(PASSED, FAILED)], [])).iter('property')
    assert {item.get('name'): item.get('value') for item in found} == {'points': '2 of 5', 'seed': '7', 'sha256': 'f00d'}


def test_what_could_not_be_graded_is_an_error() -> None:
    root = ElementTree.fromstring(junit_text([], [Refusal('b', 'no such file', 'look')]))
    error = root.find('testsuite/testcase/error')
    assert error is not None
    assert (error.get('message'), error.text) == ('no such file', 'look')


def test_no_text_can_break_the_document() -> None:
    result = CheckResult('n', NASTY, 'failed', reason=NASTY, seen=NASTY)
    root = ElementTree.fromstring(junit_text([report(result, given=NASTY)], [Refusal(NASTY, NASTY)]))
    assert root[0][1].get('name') == '<b>&"??]]>?'


def test_a_reader_of_junit_reads_it() -> None:
    junitparser = pytest.importorskip('junitparser', reason='part of the extra "dev"')
    found = junitparser.JUnitXml.fromstring(junit_text([report(PASSED, FAILED, NOT_RUN, BROKE)], [Refusal('b', 'gone')]).encode())
    suites = list(found)
    assert [(suite.tests, suite.failures, suite.errors, suite.skipped) for suite in suites] == [(4, 1, 1, 1), (1, 0, 1, 0)]
    assert [[type(result).__name__ for result in case.result] for case in suites[0]] == [[], ['Failure'], ['Skipped'], ['Error']]
    assert {item.name: item.value for item in suites[0].properties()}['points'] == 'no mark'


def test_what_could_not_be_graded_counts_as_one_error_of_one_case() -> None:
    (suite,) = ElementTree.fromstring(text_of([{'student': 'Anna', 'path': 'a.py', 'refused': 'no file', 'help': None}]))
    assert suite.attrib == {'name': 'Anna: a.py', 'tests': '1', 'failures': '0', 'errors': '1', 'skipped': '0'}
    (case,) = suite
    assert case.attrib == {'classname': 'Anna: a.py', 'name': 'It can be graded'}
    assert case[0].attrib == {'message': 'no file', 'type': 'refused'} and case[0].text is None


def test_a_suite_of_a_class_names_its_student() -> None:
    found = {'path': 'a.py', 'student': 'Anna', **document(report(PASSED, FAILED))}
    (suite,) = ElementTree.fromstring(text_of([found]))
    rubric = found['rubric']['name']
    assert suite.get('name') == f'{rubric}: Anna: a.py'
    assert suite[0][0].attrib == {'name': 'student', 'value': 'Anna'}
    assert {case.get('classname') for case in suite.findall('testcase')} == {f'edugrade.{rubric}.Anna'}
    (alone,) = ElementTree.fromstring(junit_text([report(PASSED)], []))
    assert {case.get('classname') for case in alone.findall('testcase')} == {f'edugrade.{rubric}'}
    assert alone[1].get('name') == PASSED.sentence
