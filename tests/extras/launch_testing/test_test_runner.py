"""What launch test files contain, how they are run, and the results, as data and as JUnit XML."""

from __future__ import annotations

import types
import unittest
from typing import Any
from unittest import mock

import pytest
from launch import LaunchDescription
from launch.actions import ExecuteProcess, OpaqueFunction, TimerAction
from launch_testing import actions, parametrize
from launch_testing.asserts import SequentialTextChecker
from launch_testing.junitxml import unittestResultsToXml
from launch_testing.loader import runs_of
from launch_testing.test_result import TestResult
from launch_testing.test_runner import RunWorker, run_all


def loaded(description: Any, **classes: type) -> Any:
    module = types.ModuleType('module')
    vars(module).update(classes, generate_test_description=description)
    return runs_of(module, 'launch_tests')


def result_of(test_class: type[unittest.TestCase]) -> TestResult:
    result = TestResult(lambda text: None)
    unittest.defaultTestLoader.loadTestsFromTestCase(test_class).run(result)
    return result


class Quick(unittest.TestCase):
    def test_nothing(self) -> None:
        pass


def test_processes_that_end_early_fail_the_run(capsys: pytest.CaptureFixture[str]) -> None:
    def describe(ready_fn: Any) -> LaunchDescription:
        return LaunchDescription(
            [ExecuteProcess(cmd=['sh', '-c', 'echo told; exit 3']), OpaqueFunction(function=lambda context: ready_fn())]
        )

    with mock.patch.object(RunWorker, '_run_tests'):
        (result,) = run_all(loaded(describe), [], debug=False).values()
    assert not result.wasSuccessful()
    out = capsys.readouterr().out
    assert 'Processes under test stopped before tests completed' in out and 'exited with 3' in out and 'told' in out


def test_each_parameter_is_a_run() -> None:
    def describe(delay: float) -> LaunchDescription:
        return LaunchDescription(
            [TimerAction(period=delay, actions=[actions.ReadyToTest()]), TimerAction(period=9.0, actions=[])]
        )

    results = run_all(loaded(parametrize('delay', [1.0, 2.0])(describe), Quick=Quick), [], debug=False)
    assert [(str(run), result.wasSuccessful(), len(result.testTimes)) for run, result in results.items()] == [
        ('launch_tests[1.0]', True, 1),
        ('launch_tests[2.0]', True, 1),
    ]


def test_arguments_that_nobody_gives_are_told() -> None:
    def describe(surprise: Any) -> None: ...

    with pytest.raises(TypeError, match='surprise'):
        run_all(loaded(describe), [], debug=False)


def test_two_ready_actions_are_refused() -> None:
    with pytest.raises(Exception, match='containing only one ReadyToTest action'):
        run_all(loaded(lambda: LaunchDescription([actions.ReadyToTest(), actions.ReadyToTest()])), [], debug=False)


def test_a_launch_may_be_skipped() -> None:
    def describe() -> None:
        raise unittest.SkipTest('not here')

    results = run_all(loaded(describe), [], debug=False)
    (result,) = results.values()
    assert result.wasSuccessful() and [reason for _, reason in result.skipped] == ['not here']
    (suite,) = unittestResultsToXml(name='all', test_results=results).getroot()
    assert [(case.get('name'), case.find('skipped').get('message')) for case in suite] == [('launch_tests', 'not here')]


def test_a_class_that_cannot_be_set_up_is_in_the_xml() -> None:
    class Broken(unittest.TestCase):
        @classmethod
        def setUpClass(cls) -> None:
            raise ValueError('no')

        def test_it(self) -> None: ...

    result = result_of(Broken)
    result.notes.append('and the launch')
    (suite,) = unittestResultsToXml(name='all', test_results={'a': result}).getroot()  # type: ignore[dict-item]
    assert [(suite.get(name)) for name in ('name', 'tests', 'errors', 'failures')] == ['all.a', '0', '1', '1']
    assert [problem.get('message') for case in suite for problem in case] == ['ValueError: no', 'and the launch']


def test_parts_of_a_test_have_its_name() -> None:
    class Parts(unittest.TestCase):
        def test_it(self) -> None:
            with self.subTest(i=1):
                self.fail('no')

    result = result_of(Parts)
    (problem,) = result.problems()
    where = f'{__name__}.{Parts.__qualname__}.test_it'
    assert problem[:2] == ('FAIL', f'test_it ({where}) (i=1)')
    ((case,),) = unittestResultsToXml(test_results={'a': result}).getroot()  # type: ignore[dict-item]
    assert f'{case.get("classname")}.{case.get("name")}' == where and case.find('failure').text == problem[2]


def test_pieces_are_searched_in_order() -> None:
    checker = SequentialTextChecker(['one two\n', 'three\n'])
    checker.assertInStdout('two')
    checker.assertInStdout('three')
    with pytest.raises(AssertionError):
        checker.assertInStdout('one')
