"""Runs launch tests."""

from __future__ import annotations

import unittest
from collections.abc import Sequence
from typing import Any

from launch.actions.include_launch_description import IncludeLaunchDescription
from launch.actions.register_event_handler import RegisterEventHandler
from launch.event_handlers import OnProcessExit, OnProcessIO, OnProcessStart
from launch.launch_description import LaunchDescription
from launch.launch_description_source import LaunchDescriptionSource
from launch.launch_service import LaunchService
from ros2launch.api import parse_launch_arguments

from edulaunch.engine.processes.current import current_process
from edulaunch.engine.sim.sync import Event
from edulaunch.engine.sim.task import Task

from .io_handler import ActiveIoHandler
from .loader import TestRun, give
from .proc_info_handler import ActiveProcInfoHandler
from .test_result import TestResult


def run_all(test_runs: Sequence[TestRun], arguments: Sequence[str], debug: bool) -> dict[TestRun, TestResult]:
    """Run launches with their tests, one after the other, in the running process. Return the results.

    :param arguments: launch arguments of the form `name:=value`.
    :param debug: whether launch logs at level DEBUG.
    :raises Exception: any exception of `generate_test_description`.
    """
    process, results = current_process(), {}
    for test_run in test_runs:
        if len(test_runs) > 1:
            process.streams.stdout.write(f'Starting test run {test_run}\n')
        results[test_run] = TestResult(process.streams.stderr.write)
        try:
            RunWorker(test_run, results[test_run], arguments, debug).run()
        except unittest.SkipTest as skip:
            results[test_run].skipped.append((test_run, str(skip)))  # type: ignore[arg-type]
    return results


class RunWorker:
    """Launches a test's description in the main task of the running process, and runs its tests in another task.

    Both tasks run concurrently in simulated time, so tests may sleep, wait for output and spin nodes.
    """

    def __init__(self, test_run: TestRun, result: TestResult, arguments: Sequence[str], debug: bool) -> None:
        self._run = test_run
        self._result = result
        self._arguments = parse_launch_arguments(arguments)
        self._process = current_process()
        self._ready = Event()
        self._done = Event()
        self._proc_info = ActiveProcInfoHandler()
        self._proc_output = ActiveIoHandler()
        self._launch_service = LaunchService(debug=debug)

    def run(self) -> None:
        """Launch the description, run the tests, shut the launch down, and run the tests after the shutdown."""
        began = self._process.sim.elapsed_s
        description, context = self._run.description(self._ready.set)
        attributes = {'proc_info': self._proc_info, 'proc_output': self._proc_output, 'test_args': dict(self._arguments)}
        values = {**self._run.parameters, **context, **attributes}
        give(self._run.pre_shutdown_tests, attributes, {**values, 'launch_service': self._launch_service})
        give(self._run.post_shutdown_tests, attributes, values)
        self._launch_service.include_launch_description(self._watched(description))
        tests = self._process.start_thread(self._run_tests, 'test_runner', daemon=True)
        self._launch_service.run(shutdown_when_idle=not self._run.keeps_alive)
        if self._done.is_set():
            self._execute(self._run.post_shutdown_tests)
        else:
            self._give_up(tests)
        self._result.print_summary(self._process.sim.elapsed_s - began)

    def _watched(self, description: LaunchDescription) -> LaunchDescription:
        info, output = self._proc_info, self._proc_output

        def on_start(event: Any, _: object) -> None:
            info.append(event)
            output.track(event.action)

        return LaunchDescription(
            [
                RegisterEventHandler(OnProcessStart(on_start=on_start)),
                RegisterEventHandler(OnProcessExit(on_exit=lambda event, _: info.append(event))),
                RegisterEventHandler(OnProcessIO(on_stdout=output.append, on_stderr=output.append)),
                IncludeLaunchDescription(LaunchDescriptionSource(description), launch_arguments=self._arguments),
            ]
        )

    def _run_tests(self) -> None:
        try:
            if self._ready.wait(self._run.timeout_s):
                self._execute(self._run.pre_shutdown_tests)
                self._done.set()
            else:
                self._process.streams.stdout.write('Timed out waiting for processes to start up\n')
        finally:
            self._launch_service.shutdown()

    def _execute(self, tests: Sequence[unittest.TestCase]) -> None:
        result = TestResult(self._process.streams.stderr.write)
        try:
            unittest.TestSuite(tests).run(result)
        finally:
            self._result.append(result)

    def _give_up(self, tests: Task) -> None:
        message = 'Processes under test stopped before tests completed'
        help = f'\n  help: ReadyToTest was not reached within {self._run.timeout_s} s of simulated time'
        self._result.notes.append(message + ('' if self._ready.is_set() else help))
        tests.kill()
        self._process.streams.stdout.write(f'{message}\n')
        for info in self._proc_info:
            code = getattr(info, 'returncode', 0)
            if code:
                self._process.streams.stdout.write(f"Process '{info.process_name}' exited with {code}\n" + self._output_of(info))

    def _output_of(self, info: Any) -> str:
        rule = f"##### '{info.process_name}' output #####\n"
        text = b''.join(piece.text for piece in self._proc_output[info.action]).decode(errors='replace')
        return f'{rule}{text}{"#" * (len(rule) - 1)}\n' if text else ''
