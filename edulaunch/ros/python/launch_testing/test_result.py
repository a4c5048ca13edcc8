"""The results of tests."""

from __future__ import annotations

import unittest
from collections.abc import Callable
from types import TracebackType
from typing import Any

from edulaunch.engine.processes.traceback_text import student_traceback
from edulaunch.engine.sim.task import TaskKilled, current_task

ErrorInfo = Any  # (type, exception, traceback), as in unittest
RULE = '-' * 70


class TestResult(unittest.TestResult):
    """Collects the outcomes of tests, and prints each as `name ... ok`. Durations are in simulated seconds.

    :param write: a function that is called with each printed line.
    :ivar testTimes: the duration of each test in seconds, in the order in which the tests were run.
    """

    __test__ = False  # pytest must not collect this class as a test case

    def __init__(self, write: Callable[[str], object]) -> None:
        super().__init__()
        self._write = write
        self._began_ns = 0
        self.testTimes: dict[Any, float] = {}
        self.notes: list[str] = []

    def note_failure(self, message: str) -> None:
        """Record an error outside any test."""
        self.notes.append(message)

    def wasSuccessful(self) -> bool:
        """Return whether all tests passed."""
        return super().wasSuccessful() and not self.notes

    def append(self, other: TestResult) -> None:
        """Add the results of further tests."""
        for name in ('failures', 'errors', 'skipped', 'expectedFailures', 'unexpectedSuccesses', 'notes'):
            getattr(self, name).extend(getattr(other, name))
        self.testsRun += other.testsRun
        self.testTimes.update(other.testTimes)

    # -- called by unittest

    def startTest(self, test: unittest.TestCase) -> None:
        """Record that a test has started."""
        self.testsRun += 1
        self._began_ns = current_task().sim.now_ns
        self._write(f'{title(test)} ... ')

    def stopTest(self, test: unittest.TestCase) -> None:
        """Record that a test has ended."""
        self.testTimes[test] = (current_task().sim.now_ns - self._began_ns) / 1e9

    def addSuccess(self, test: unittest.TestCase) -> None:
        """Record a passed test."""
        self._write('ok\n')

    def addFailure(self, test: unittest.TestCase, err: ErrorInfo) -> None:
        """Record a failed assertion."""
        self.failures.append((test, _text(err)))
        self._write('FAIL\n')

    def addError(self, test: unittest.TestCase, err: ErrorInfo) -> None:
        """Record any other exception. If the process that runs the test is killed, the test ends, too."""
        if issubclass(err[0], TaskKilled):
            raise err[1]
        if is_pytest_outcome(err[1]) and err[0].__name__ == 'Skipped':
            self.addSkip(test, str(err[1]))
            return
        self.errors.append((test, _text(err)))
        self._write('ERROR\n')

    def addSubTest(self, test: unittest.TestCase, subtest: unittest.TestCase, err: ErrorInfo | None) -> None:
        """Record the end of a subtest."""
        if err is not None:
            (self.addFailure if issubclass(err[0], test.failureException) else self.addError)(subtest, err)

    def addSkip(self, test: unittest.TestCase, reason: str) -> None:
        """Record a skipped test."""
        self.skipped.append((test, reason))
        self._write(f'skipped {reason!r}\n')

    def addExpectedFailure(self, test: unittest.TestCase, err: ErrorInfo) -> None:
        """Record a test that failed as expected."""
        self.expectedFailures.append((test, _text(err)))
        self._write('expected failure\n')

    def addUnexpectedSuccess(self, test: unittest.TestCase) -> None:
        """Record a test that passed but should have failed."""
        self.unexpectedSuccesses.append(test)
        self._write('unexpected success\n')

    def addDuration(self, test: unittest.TestCase, elapsed: float) -> None:
        """Ignore real time, because durations are in simulated time."""

    def problems(self) -> list[tuple[str, str, str]]:
        """Return (kind, test, message) for every failure."""
        return [
            *(('ERROR', title(test), text) for test, text in self.errors),
            *(('FAIL', title(test), text) for test, text in self.failures),
            *(('UNEXPECTED SUCCESS', title(test), '') for test in self.unexpectedSuccesses),
            *(('FAIL', 'launch', note) for note in self.notes),
        ]

    def print_summary(self, seconds: float) -> None:
        """Print the failures and the number of tests."""
        for what, name, text in self.problems():
            self._write(f'\n{"=" * 70}\n{what}: {name}\n{RULE}\n{text.rstrip()}\n')
        self._write(f'\n{RULE}\nRan {self.testsRun} test{"" if self.testsRun == 1 else "s"} in {seconds:.3f}s\n\n')
        self._write('OK\n' if self.wasSuccessful() else 'FAILED\n')


def is_pytest_outcome(error: BaseException) -> bool:
    """Return whether `pytest.skip()` or `pytest.fail()` raised the exception. The class of such an exception is not derived from
    Exception, and its repr does not show its origin.
    """
    return any(cls.__name__ == 'OutcomeException' for cls in type(error).__mro__)


def title(test: Any) -> str:
    """Return a test's name in unittest's form, `test_x (module.Class.test_x)`, which is the same in every version of Python."""
    if not isinstance(test, unittest.TestCase):
        return str(test)
    name = getattr(test, 'test_case', test).id()  # a sub-test has the name of its test
    return f'{name.rpartition(".")[2]} ({name}){test.id()[len(name) :]}'


def _text(err: ErrorInfo) -> str:
    error = err[1]
    return student_traceback(error.with_traceback(_without_unittest(err[2])))[0]


def _without_unittest(trace: TracebackType | None) -> TracebackType | None:
    levels = []
    while trace is not None:
        if '__unittest' not in trace.tb_frame.f_globals:
            levels.append(trace)
        trace = trace.tb_next
    shortened = None
    for level in reversed(levels):
        shortened = TracebackType(shortened, level.tb_frame, level.tb_lasti, level.tb_lineno)
    return shortened
