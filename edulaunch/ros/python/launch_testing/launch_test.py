"""Runs a launch test: a file with launches and their tests. The test runs inside a simulated process, which other code
creates.
"""

from __future__ import annotations

import os
from collections.abc import Sequence

from edulaunch.engine.processes.current import current_process
from edulaunch.engine.processes.traceback_text import student_traceback

from .loader import TestRun, runs_of
from .test_result import TestResult, is_pytest_outcome


class LaunchTest:
    """One run of a test file. The object can be created anywhere, but :meth:`run` must be called inside a simulated process.

    :param path: the path of the test file.
    :param arguments: launch arguments of the form `name:=value`.
    :ivar results: the results of each launch; empty before the run.
    :ivar error: the error that prevented the file from running, or None.
    """

    def __init__(self, path: str, arguments: Sequence[str] = (), *, debug: bool = False) -> None:
        self.path = os.path.abspath(path)
        self.name = os.path.splitext(os.path.basename(path))[0].replace('.', '_')
        self.arguments = list(arguments)
        self.debug = debug
        self.results: dict[TestRun, TestResult] = {}
        self.error: BaseException | None = None

    def load(self) -> list[TestRun]:
        """Execute the file with the private modules of the running process, and return its launches."""
        module = current_process().loader.run_file(self.path, self.name)
        if not hasattr(module, 'generate_test_description'):
            raise AttributeError(f"Test file '{self.path}' does not contain generate_test_description function")
        return runs_of(module, self.name)

    def run(self) -> int:
        """Run all launches and tests in the file. Return 0 if all tests passed, and otherwise 1."""
        from .test_runner import run_all

        try:
            self.results = run_all(self.load(), self.arguments, self.debug)
        except BaseException as error:
            if not isinstance(error, Exception) and not is_pytest_outcome(error):
                raise
            self.error = error
            current_process().streams.stderr.write(self.error_text())
            return 1
        return 0 if all(result.wasSuccessful() for result in self.results.values()) else 1

    def error_text(self) -> str:
        """Return the message of `error`, with the traceback's lines in the student's code, if there are any."""
        assert self.error is not None
        text, place = student_traceback(self.error)
        return text if place is not None else f'{type(self.error).__name__}: {self.error}\n'

    def show_arguments(self) -> int:
        """Print the launch arguments of the first description, and return 0."""
        from ros2launch.api.api import arguments_text

        description, _ = self.load()[0].description(lambda: None)
        current_process().streams.stdout.write(arguments_text(description) + '\n')
        return 0
