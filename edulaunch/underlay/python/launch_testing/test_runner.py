"""Running launch tests."""

from __future__ import annotations

import unittest
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

from launch._lazy import has_ros_paths

from edulaunch.processes.current import current_process

from .loader import TestRun
from .test_result import SkipResult, TestResult

if TYPE_CHECKING:
    from launch.launch_description_entity import LaunchDescriptionEntity


class LaunchTestRunner:
    """Runs launches with their tests, one after the other, in the running process.

    :param test_runs: see :func:`launch_testing.LoadTestsFromPythonModule`.
    :param launch_file_arguments: texts `name:=value`.
    :param debug: let launch log at level DEBUG.
    """

    def __init__(self, test_runs: Sequence[TestRun], launch_file_arguments: Sequence[str] = (), debug: bool = False) -> None:
        self._test_runs = list(test_runs)
        self._arguments = list(launch_file_arguments)
        self._debug = debug

    def generate_preamble(self) -> list[LaunchDescriptionEntity]:
        """What is launched before each test description; a runner of one's own may give something."""
        return []

    def validate(self) -> None:
        """Check all `generate_test_description` before anything is launched.

        :raises TypeError: when one wants arguments that nobody gives.
        """
        for test_run in self._test_runs:
            test_run.validate()

    def run(self) -> dict[TestRun, TestResult]:
        """Run all; gives how each went.

        :raises Exception: what generating a description raised.
        """
        return {test_run: self._run_one(test_run) for test_run in self._test_runs}

    def _run_one(self, test_run: TestRun) -> TestResult:
        from ._run_worker import RunWorker

        if len(self._test_runs) > 1:
            current_process().stdout.write(f'Starting test run {test_run}\n')
        try:
            return RunWorker(test_run, self._arguments, self._debug, self.generate_preamble()).run()
        except unittest.SkipTest as skip:
            return SkipResult(test_run, str(skip))


def __getattr__(name: str) -> Any:
    # It needs all of launch, which those who only read a test file do without.
    if name == '_RunnerWorker':
        from ._run_worker import RunWorker

        return RunWorker
    raise AttributeError(f'module {__name__!r} has no attribute {name!r}')


class ReadyAggregator:
    """Calls a function when `ready_fn` has been called so many times.

    :param parent_ready_fn: the function; it is called once.
    :param num_calls: how many calls it takes.
    """

    def __init__(self, parent_ready_fn: Callable[[], object], num_calls: int) -> None:
        self._parent_ready_fn = parent_ready_fn
        self._missing = num_calls

    def ready_fn(self) -> None:
        """One more thing is ready."""
        self._missing -= 1
        if self._missing == 0:
            self._parent_ready_fn()


has_ros_paths(__name__)
