"""Names that other code imports from launch_testing and launch_testing_ros."""

from __future__ import annotations

import unittest
from pathlib import Path
from typing import Any
from unittest import mock

import launch_testing
import pytest
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, TimerAction
from launch_testing.junitxml import unittestCaseToXml, unittestResultToXml
from launch_testing.launch_test import print_arguments_of_launch_description
from launch_testing.pytest import hooks
from launch_testing.test_result import TestResult
from launch_testing.test_runner import LaunchTestRunner
from launch_testing_ros.pytest import hooks as ros_hooks


def test_ready_aggregator_calls_once() -> None:
    ready = mock.Mock()
    aggregator = launch_testing.ReadyAggregator(ready, 2)
    for calls in (0, 1, 1):
        aggregator.ready_fn()
        assert ready.call_count == calls


def test_arguments_are_printed(capsys: pytest.CaptureFixture[str]) -> None:
    print_arguments_of_launch_description(launch_description=LaunchDescription([DeclareLaunchArgument('speed')]))
    assert (
        capsys.readouterr().out
        == "Arguments (pass arguments as '<name>:=<value>'):\n\n    'speed':\n        no description given\n"
    )


def test_a_class_that_cannot_be_set_up_is_in_the_xml() -> None:
    class Broken(unittest.TestCase):
        @classmethod
        def setUpClass(cls) -> None:
            raise ValueError('no')

        def test_it(self) -> None: ...

    result = TestResult()
    unittest.defaultTestLoader.loadTestsFromTestCase(Broken).run(result)  # type: ignore[arg-type]
    suite = unittestResultToXml('mine', result)
    assert [case.find('error').get('message') for case in suite] == ['ValueError: no']


def test_a_case_is_written_as_xml() -> None:
    case = unittest.FunctionTestCase(lambda: None)
    result = TestResult()
    case.run(result)  # type: ignore[arg-type]
    assert unittestCaseToXml(result, case).get('name') == 'runTest'


def test_a_runner_may_launch_something_before() -> None:
    seen: list[str] = []

    class Runner(LaunchTestRunner):
        def generate_preamble(self) -> list[Any]:
            from launch.actions import OpaqueFunction

            return [OpaqueFunction(function=lambda context: seen.append('preamble'))]

    description = LaunchDescription([launch_testing.actions.ReadyToTest(), TimerAction(period=5.0, actions=[])])
    module: Any = mock.NonCallableMock(spec=['generate_test_description'], generate_test_description=lambda: description)
    Runner(launch_testing.LoadTestsFromPythonModule(module)).run()
    assert seen == ['preamble']


def test_hooks_know_launch_tests(tmp_path: Path) -> None:
    file = tmp_path / 'test_it.py'
    file.write_text('@pytest.mark.rostest\ndef generate_test_description(): ...\n')
    entrypoint = hooks.find_launch_test_entrypoint(file)
    assert entrypoint is not None and [mark.name for mark in entrypoint.pytestmark] == ['rostest'] and 'rostest' in hooks.MARKS
    assert issubclass(ros_hooks.LaunchROSTestModule, pytest.File) and issubclass(hooks.LaunchTestItem, pytest.Item)
