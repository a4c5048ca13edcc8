"""Results as JUnit XML, the format that build servers read."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any
from xml.etree import ElementTree

if TYPE_CHECKING:
    from .loader import TestRun
    from .test_result import TestResult


def unittestResultsToXml(*, name: str = 'launch_test', test_results: Mapping[TestRun, TestResult]) -> Any:
    """One `testsuite` for each launch, one `testcase` for each test; times are simulated seconds.

    :returns: an `xml.etree.ElementTree.ElementTree`; write it with its `write(path)`.
    """
    results = list(test_results.values())
    root = ElementTree.Element('testsuites', {'name': name, **_counts(results)})
    for run, result in test_results.items():
        root.append(unittestResultToXml(f'{name}.{run}', result, run=run))
    return ElementTree.ElementTree(root)


def unittestResultToXml(name: str, test_result: TestResult, *, run: object = 'launch') -> Any:
    """The `testsuite` of one launch.

    :param run: what a failure that is nobody's test is called after.
    """
    suite = ElementTree.Element('testsuite', {'name': name, **_counts([test_result])})
    for test in _all_cases(test_result):
        suite.append(unittestCaseToXml(test_result, test))
    for note in test_result.notes:
        ElementTree.SubElement(_case(suite, run, test_result), 'failure', {'message': note})
    return suite


def unittestCaseToXml(test_result: TestResult, test_case: Any) -> Any:
    """The `testcase` of one test, with what went wrong in it."""
    suite = ElementTree.Element('testsuite')
    case = _case(suite, test_case, test_result)
    for test, reason in test_result.skipped:
        if test is test_case:
            ElementTree.SubElement(case, 'skipped', {'message': str(reason)})
    for what, problems in (('failure', test_result.failures), ('error', test_result.errors)):
        for test, text in problems:
            if test is test_case or getattr(test, 'test_case', None) is test_case:
                found = ElementTree.SubElement(case, what, {'message': text.strip().split('\n')[-1]})
                found.text = text
    return case


def _all_cases(result: TestResult) -> list[Any]:
    """Tests that were run, and what else has an outcome: a class that could not be set up, a launch that was skipped."""
    others = [test for outcomes in (result.skipped, result.failures, result.errors) for test, _ in outcomes]
    return list(dict.fromkeys([*result.testCases, *(getattr(test, 'test_case', test) for test in others)]))


def _counts(results: list[TestResult]) -> dict[str, str]:
    return {
        'tests': str(sum(result.testsRun for result in results)),
        'failures': str(sum(len(result.failures) + len(result.notes) for result in results)),
        'errors': str(sum(len(result.errors) for result in results)),
        'skipped': str(sum(len(result.skipped) for result in results)),
        'time': f'{sum(sum(result.testTimes.values()) for result in results):.3f}',
    }


def _case(suite: Any, test: Any, result: TestResult) -> Any:
    name = getattr(test, '_testMethodName', str(test))
    cls = type(test)
    classname = f'{cls.__module__}.{cls.__qualname__}' if hasattr(test, '_testMethodName') else str(suite.get('name'))
    return ElementTree.SubElement(
        suite, 'testcase', {'classname': classname, 'name': name, 'time': f'{result.testTimes.get(test, 0.0):.3f}'}
    )
