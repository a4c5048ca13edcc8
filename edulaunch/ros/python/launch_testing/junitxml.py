"""Converts results to JUnit XML, the format that build servers read."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any
from xml.etree import ElementTree

from .loader import TestRun
from .test_result import TestResult


def unittestResultsToXml(*, name: str = 'launch_test', test_results: Mapping[TestRun, TestResult]) -> Any:
    """Return one `testsuite` for each launch, with one `testcase` for each test. Times are simulated seconds.

    :returns: an `xml.etree.ElementTree.ElementTree`. Its method `write(path)` writes the file.
    """
    root = ElementTree.Element('testsuites', {'name': name, **_counts(list(test_results.values()))})
    for run, result in test_results.items():
        suite = ElementTree.SubElement(root, 'testsuite', {'name': f'{name}.{run}', **_counts([result])})
        problems = {'skipped': result.skipped, 'failure': result.failures, 'error': result.errors}
        others = [getattr(test, 'test_case', test) for outcomes in problems.values() for test, _ in outcomes]
        for test in dict.fromkeys([*result.testTimes, *others]):
            case = _case(suite, test, result)
            for what, outcomes in problems.items():
                for which, text in outcomes:
                    if getattr(which, 'test_case', which) is test:
                        ElementTree.SubElement(case, what, {'message': text.strip().split('\n')[-1]}).text = text
        for note in result.notes:
            ElementTree.SubElement(_case(suite, run, result), 'failure', {'message': note})
    return ElementTree.ElementTree(root)


def _counts(results: Sequence[TestResult]) -> dict[str, str]:
    return {
        'tests': str(sum(result.testsRun for result in results)),
        'failures': str(sum(len(result.failures) + len(result.notes) for result in results)),
        'errors': str(sum(len(result.errors) for result in results)),
        'skipped': str(sum(len(result.skipped) for result in results)),
        'time': f'{sum(sum(result.testTimes.values()) for result in results):.3f}',
    }


def _case(suite: Any, test: Any, result: TestResult) -> Any:
    classname, _, name = test.id().rpartition('.') if hasattr(test, 'id') else (suite.get('name'), '', str(test))
    time = f'{result.testTimes.get(test, 0.0):.3f}'
    return ElementTree.SubElement(suite, 'testcase', {'classname': classname, 'name': name, 'time': time})
