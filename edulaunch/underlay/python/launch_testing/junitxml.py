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
        suite = ElementTree.SubElement(root, 'testsuite', {'name': f'{name}.{run}', **_counts([result])})
        for test in result.passed:
            _case(suite, test, result)
        for test, reason in result.skipped:
            ElementTree.SubElement(_case(suite, test, result), 'skipped', {'message': str(reason)})
        for what, problems in (('failure', result.failures), ('error', result.errors)):
            for test, text in problems:
                found = ElementTree.SubElement(_case(suite, test, result), what, {'message': text.strip().split('\n')[-1]})
                found.text = text
        for note in result.notes:
            ElementTree.SubElement(_case(suite, run, result), 'failure', {'message': note})
    return ElementTree.ElementTree(root)


def _counts(results: list[TestResult]) -> dict[str, str]:
    return {'tests': str(sum(result.testsRun for result in results)),
            'failures': str(sum(len(result.failures) + len(result.notes) for result in results)),
            'errors': str(sum(len(result.errors) for result in results)),
            'skipped': str(sum(len(result.skipped) for result in results)),
            'time': f'{sum(sum(result.testTimes.values()) for result in results):.3f}'}


def _case(suite: Any, test: Any, result: TestResult) -> Any:
    name = getattr(test, '_testMethodName', str(test))
    cls = type(test)
    classname = f'{cls.__module__}.{cls.__qualname__}' if hasattr(test, '_testMethodName') else str(suite.get('name'))
    return ElementTree.SubElement(
        suite, 'testcase', {'classname': classname, 'name': name, 'time': f'{result.testTimes.get(test, 0.0):.3f}'})
