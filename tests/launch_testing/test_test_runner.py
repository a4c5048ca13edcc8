"""The runner, the loader and the results, as unit tests of launch tests use them."""

from __future__ import annotations

import types
import unittest
from typing import Any
from unittest import mock

import pytest
from launch import LaunchDescription
from launch.actions import ExecuteProcess, OpaqueFunction, TimerAction
from launch_testing import LaunchTestRunner, LoadTestsFromPythonModule, actions, parametrize
from launch_testing.asserts import SequentialTextChecker
from launch_testing.junitxml import unittestResultsToXml
from launch_testing.test_result import FailResult, SkipResult, TestResult


def runs_of(description: Any, **classes: type) -> Any:
    module = types.ModuleType('module')
    vars(module).update(classes, generate_test_description=description)
    return LoadTestsFromPythonModule(module)


class Quick(unittest.TestCase):
    def test_nothing(self) -> None:
        pass


def test_processes_that_end_early_fail_the_run(capsys: pytest.CaptureFixture[str]) -> None:
    def describe(ready_fn: Any) -> LaunchDescription:
        return LaunchDescription(
            [ExecuteProcess(cmd=['sh', '-c', 'echo told; exit 3']), OpaqueFunction(function=lambda context: ready_fn())]
        )

    with mock.patch('launch_testing.test_runner._RunnerWorker._run_test'):
        (result,) = LaunchTestRunner(runs_of(describe)).run().values()
    assert not result.wasSuccessful()
    out = capsys.readouterr().out
    assert 'Processes under test stopped before tests completed' in out and 'exited with 3' in out and 'told' in out


def test_each_parameter_is_a_run() -> None:
    def describe(delay: float) -> LaunchDescription:
        return LaunchDescription(
            [TimerAction(period=delay, actions=[actions.ReadyToTest()]), TimerAction(period=9.0, actions=[])]
        )

    runner = LaunchTestRunner(runs_of(parametrize('delay', [1.0, 2.0])(describe), Quick=Quick))
    runner.validate()
    results = runner.run()
    assert [(str(run), result.wasSuccessful(), len(result.testCases)) for run, result in results.items()] == [
        ('launch_tests[1.0]', True, 1),
        ('launch_tests[2.0]', True, 1),
    ]


def test_arguments_that_nobody_gives_are_found_before_launching() -> None:
    with pytest.raises(TypeError, match='surprise'):
        LaunchTestRunner(runs_of(lambda surprise: None)).validate()


def test_parameters_that_the_description_does_not_take_are_found_too() -> None:
    def describe(ready_fn: Any) -> None: ...

    with pytest.raises(TypeError, match='speed'):
        LaunchTestRunner(runs_of(parametrize('speed', [1, 2])(describe))).validate()


def test_two_ready_actions_are_refused() -> None:
    with pytest.raises(Exception, match='containing only one ReadyToTest action'):
        LaunchTestRunner(runs_of(lambda: LaunchDescription([actions.ReadyToTest(), actions.ReadyToTest()]))).run()


def test_run_shows_its_description_and_cases() -> None:
    (run,) = runs_of(lambda: LaunchDescription([actions.ReadyToTest()]), Quick=Quick)
    assert isinstance(run.get_launch_description().entities[0], actions.ReadyToTest)
    assert [type(case) for case in run.all_cases()] == [Quick]


def test_results_of_whole_launches_are_written_as_xml() -> None:
    tree = unittestResultsToXml(name='all', test_results={'a': FailResult(), 'b': SkipResult(None, 'why')})  # type: ignore[dict-item]
    assert [(suite.get('name'), suite.get('failures'), suite.get('skipped')) for suite in tree.getroot()] == [
        ('all.a', '1', '0'),
        ('all.b', '0', '1'),
    ]


def test_result_class_suits_the_text_runner(capsys: pytest.CaptureFixture[str]) -> None:
    runner = unittest.TextTestRunner(resultclass=TestResult)  # type: ignore[arg-type]
    result: Any = runner.run(unittest.defaultTestLoader.loadTestsFromTestCase(Quick))
    assert result.wasSuccessful() and [case.id() for case in result.passed] == [case.id() for case in result.testCases]
    assert 'test_nothing' in capsys.readouterr().err


def test_pieces_are_searched_in_order() -> None:
    checker = SequentialTextChecker(['one two\n', 'three\n'])
    checker.assertInStdout('two')
    checker.assertInStdout('three')
    with pytest.raises(AssertionError):
        checker.assertInStdout('one')
