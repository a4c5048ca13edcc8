"""How tests went."""

from __future__ import annotations

import unittest
from collections.abc import Callable
from types import TracebackType
from typing import Any

from edulaunch.processes.traceback_text import student_traceback
from edulaunch.sim.task import TaskKilled, current_task

ErrorInfo = Any  # (type, exception, traceback), as in unittest
RULE = '-' * 70


class TestResult(unittest.TestResult):
    """Collects the outcome of tests and tells each as `name ... ok`; durations are in simulated seconds.

    :param stream: where the lines go; None: nowhere.
    :ivar testTimes: seconds by test.
    :ivar passed: the tests that passed, in order.
    """

    __test__ = False  # pytest is not to take this class for a test case

    def __init__(self, stream: Any = None, descriptions: bool | None = None, verbosity: int | None = None) -> None:
        super().__init__(stream, descriptions, verbosity)
        self._write: Callable[[str], object] = stream.write if stream is not None else lambda text: None
        self._began_ns = 0
        self.testTimes: dict[Any, float] = {}
        self.passed: list[Any] = []
        self.notes: list[str] = []

    @property
    def testCases(self) -> list[Any]:
        """All tests that were run, in order."""
        return list(self.testTimes)

    def note_failure(self, message: str) -> None:
        """Something that is nobody's test went wrong."""
        self.notes.append(message)

    def wasSuccessful(self) -> bool:
        """Whether nothing went wrong."""
        return super().wasSuccessful() and not self.notes

    def append(self, other: TestResult) -> None:
        """Add the outcome of further tests."""
        for name in ('failures', 'errors', 'skipped', 'expectedFailures', 'unexpectedSuccesses', 'passed', 'notes'):
            getattr(self, name).extend(getattr(other, name))
        self.testsRun += other.testsRun
        self.testTimes.update(other.testTimes)

    # -- called by unittest

    def startTest(self, test: unittest.TestCase) -> None:
        """A test begins."""
        self.testsRun += 1
        self._began_ns = current_task().sim.now_ns
        self._write(f'{title(test)} ... ')

    def stopTest(self, test: unittest.TestCase) -> None:
        """A test has ended."""
        self.testTimes[test] = (current_task().sim.now_ns - self._began_ns) / 1e9

    def addSuccess(self, test: unittest.TestCase) -> None:
        """It passed."""
        self.passed.append(test)
        self._write('ok\n')

    def addFailure(self, test: unittest.TestCase, err: ErrorInfo) -> None:
        """What it claimed was not so."""
        self.failures.append((test, _text(err)))
        self._write('FAIL\n')

    def addError(self, test: unittest.TestCase, err: ErrorInfo) -> None:
        """Something else broke in it. A test whose process is being ended goes no further."""
        if issubclass(err[0], TaskKilled):
            raise err[1]
        if is_pytest_outcome(err[1]) and err[0].__name__ == 'Skipped':
            self.addSkip(test, str(err[1]))
            return
        self.errors.append((test, _text(err)))
        self._write('ERROR\n')

    def addSubTest(self, test: unittest.TestCase, subtest: unittest.TestCase, err: ErrorInfo | None) -> None:
        """A part of it has ended."""
        if err is not None:
            (self.addFailure if issubclass(err[0], test.failureException) else self.addError)(subtest, err)

    def addSkip(self, test: unittest.TestCase, reason: str) -> None:
        """It was not run."""
        self.skipped.append((test, reason))
        self._write(f'skipped {reason!r}\n')

    def addExpectedFailure(self, test: unittest.TestCase, err: ErrorInfo) -> None:
        """It failed, as it should."""
        self.expectedFailures.append((test, _text(err)))
        self._write('expected failure\n')

    def addUnexpectedSuccess(self, test: unittest.TestCase) -> None:
        """It passed, but should not."""
        self.unexpectedSuccesses.append(test)
        self._write('unexpected success\n')

    def addDuration(self, test: unittest.TestCase, elapsed: float) -> None:
        """Real time, in which nobody here is interested."""

    def problems(self) -> list[tuple[str, str, str]]:
        """(what, which test, text) of everything that went wrong."""
        return [
            *(('ERROR', title(test), text) for test, text in self.errors),
            *(('FAIL', title(test), text) for test, text in self.failures),
            *(('UNEXPECTED SUCCESS', title(test), '') for test in self.unexpectedSuccesses),
            *(('FAIL', 'launch', note) for note in self.notes),
        ]

    def print_summary(self, seconds: float) -> None:
        """Tell what went wrong, and how many tests there were."""
        for what, name, text in self.problems():
            self._write(f'\n{"=" * 70}\n{what}: {name}\n{RULE}\n{text.rstrip()}\n')
        self._write(f'\n{RULE}\nRan {self.testsRun} test{"" if self.testsRun == 1 else "s"} in {seconds:.3f}s\n\n')
        self._write('OK\n' if self.wasSuccessful() else 'FAILED\n')


class FailResult(TestResult):
    """Of a launch that broke before its tests could tell.

    :param test_run: which one.
    :param message: what happened.
    """

    def __init__(self, test_run: Any = None, message: str = '') -> None:
        super().__init__()
        self.test_run = test_run
        self.note_failure(message)


class SkipResult(TestResult):
    """Of a launch that was skipped as a whole.

    :param test_run: which one.
    :param skip_reason: why.
    """

    def __init__(self, test_run: Any = None, skip_reason: str = '') -> None:
        super().__init__()
        self.test_run = test_run
        self.skipped.append((test_run, skip_reason))


def is_pytest_outcome(error: BaseException) -> bool:
    """Whether `pytest.skip()` or `pytest.fail()` raised it; these are no Exceptions, and hide where they come from."""
    return any(cls.__name__ == 'OutcomeException' for cls in type(error).__mro__)


def title(test: Any) -> str:
    """A test's name as unittest tells it: `test_x (module.Class.test_x)`; the same on every version of Python."""
    name = getattr(test, '_testMethodName', None)
    if name is None:
        case = getattr(test, 'test_case', None)
        return str(test) if case is None else f'{title(case)} {test._subDescription()}'
    return f'{name} ({type(test).__module__}.{type(test).__qualname__}.{name})'


def _text(err: ErrorInfo) -> str:
    error = err[1]
    return student_traceback(error.with_traceback(_without_unittest(err[2])))[0]


def _without_unittest(trace: TracebackType | None) -> TracebackType | None:
    levels = []
    while trace is not None:
        if '__unittest' not in trace.tb_frame.f_globals:
            levels.append(trace)
        trace = trace.tb_next
    kept = None
    for level in reversed(levels):
        kept = TracebackType(kept, level.tb_frame, level.tb_lasti, level.tb_lineno)
    return kept
