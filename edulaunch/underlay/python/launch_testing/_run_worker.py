"""One launch with its tests."""

from __future__ import annotations

import unittest
from collections.abc import Sequence
from typing import Any

from launch.actions.events import RegisterEventHandler
from launch.actions.include_launch_description import IncludeLaunchDescription
from launch.event_handlers import OnProcessExit, OnProcessIO, OnProcessStart
from launch.launch_description import LaunchDescription
from launch.launch_description_entity import LaunchDescriptionEntity
from launch.launch_description_source import LaunchDescriptionSource
from launch.launch_service import LaunchService
from ros2launch.api import parse_launch_arguments

from edulaunch.processes.current import current_process
from edulaunch.sim.sync import Event
from edulaunch.sim.task import Task

from .io_handler import ActiveIoHandler
from .loader import TestRun
from .proc_info_handler import ActiveProcInfoHandler
from .test_result import TestResult


class RunWorker:
    """Launches a test's description in the main task of the running process, and runs its tests in another.

    Both give their turns to each other in simulated time, so tests may sleep, wait for output and spin nodes.

    :param arguments: launch arguments, `name:=value`.
    :param preamble: is launched before the test's description.
    """

    def __init__(
        self, test_run: TestRun, arguments: Sequence[str], debug: bool, preamble: Sequence[LaunchDescriptionEntity] = ()
    ) -> None:
        self._run = test_run
        self._preamble = preamble
        self._arguments = parse_launch_arguments(arguments)
        self._process = current_process()
        self._ready = Event()
        self._done = Event()
        self._proc_info = ActiveProcInfoHandler()
        self._proc_output = ActiveIoHandler()
        self._launch_service = LaunchService(debug=debug)
        self._result = TestResult(self._process.stderr)

    def run(self) -> TestResult:
        """Launch, test, shut down, test again."""
        began = self._process.sim.elapsed_s
        description, context = self._run.normalized_test_description(self._ready.set)
        values = {
            **self._run.param_args,
            **context,
            'proc_info': self._proc_info,
            'proc_output': self._proc_output,
            'test_args': dict(self._arguments),
        }
        self._launch_service.include_launch_description(self._watched(description))
        tests = self._process.start_thread(lambda: self._run_test(values), 'test_runner', daemon=True)
        self._launch_service.run(shutdown_when_idle=not self._run.markers.get('keep_alive', False))
        if self._done.is_set():
            self._execute(self._run.post_shutdown_tests, values)
        else:
            self._give_up(tests)
        self._result.print_summary(self._process.sim.elapsed_s - began)
        return self._result

    def _watched(self, description: LaunchDescription) -> LaunchDescription:
        info, output = self._proc_info, self._proc_output

        def on_start(event: Any, _: object) -> None:
            info.append(event)
            output.track(event.action)

        def on_exit(event: Any, _: object) -> None:
            info.append(event)

        return LaunchDescription(
            [
                RegisterEventHandler(OnProcessStart(on_start=on_start)),
                RegisterEventHandler(OnProcessExit(on_exit=on_exit)),
                RegisterEventHandler(OnProcessIO(on_stdout=output.append, on_stderr=output.append)),
                *self._preamble,
                IncludeLaunchDescription(LaunchDescriptionSource(description), launch_arguments=self._arguments),
            ]
        )

    def _run_test(self, values: dict[str, Any]) -> None:
        if not self._ready.wait(self._run.timeout_s):
            self._process.stdout.write('Timed out waiting for processes to start up\n')
            self._launch_service.shutdown()
            return
        try:
            self._execute(self._run.pre_shutdown_tests, {**values, 'launch_service': self._launch_service})
            self._done.set()
        finally:
            self._launch_service.shutdown()

    def _execute(self, tests: Sequence[unittest.TestCase], values: dict[str, Any]) -> None:
        attributes = {name: values[name] for name in ('proc_info', 'proc_output', 'test_args')}
        self._run.bind(tests, attributes, values)
        result = TestResult(self._process.stderr)
        try:
            unittest.TestSuite(tests).run(result)
        finally:
            self._result.append(result)

    def _give_up(self, tests: Task) -> None:
        message = 'Processes under test stopped before tests completed'
        if not self._ready.is_set():
            message += f'\n  help: ReadyToTest was not reached within {self._run.timeout_s} s of simulated time'
        self._result.note_failure(message)
        tests.kill()
        self._process.stdout.write(message.partition('\n')[0] + '\n')
        for info in self._proc_info:
            code = getattr(info, 'returncode', 0)
            if code:
                self._process.stdout.write(f"Process '{info.process_name}' exited with {code}\n" + self._output_of(info))

    def _output_of(self, info: Any) -> str:
        rule = f"##### '{info.process_name}' output #####\n"
        text = b''.join(piece.text for piece in self._proc_output[info.action]).decode(errors='replace')
        return f'{rule}{text}{"#" * (len(rule) - 1)}\n' if text else ''
