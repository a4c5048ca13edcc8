"""The output of the processes of a launch test, which tests receive as `proc_output`."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from launch.events.process.process_io import ProcessIO

from ._by_process import _ByProcess
from .asserts.assert_output import assertInStream
from .util.proc_lookup import CmdArgs, NoMatchingProcessException


class IoHandler(_ByProcess[list[ProcessIO]]):
    """All output of the processes, in order and by process."""

    def __init__(self) -> None:
        super().__init__()
        self._sequence: list[ProcessIO] = []

    def append(self, process_io: ProcessIO) -> None:
        """Record a part of the output, and wake the tasks that wait for output."""
        self._sequence.append(process_io)
        self._recorded.setdefault(process_io.action, []).append(process_io)
        self._tell()

    def track(self, action: Any) -> None:
        """Record that a process has started, even if it never writes anything."""
        self._recorded.setdefault(action, [])

    def __iter__(self) -> Iterator[ProcessIO]:
        return iter(list(self._sequence))


class ActiveIoHandler(IoHandler):
    """The output for tests that run at the same time as the processes. Tests can wait for output in simulated time."""

    def waitFor(
        self,
        expected_output: Any,
        process: Any = None,
        cmd_args: CmdArgs = None,
        *,
        timeout: float = 10,
        stream: str = 'stderr',
        **options: Any,
    ) -> bool:
        """Wait for output. Return False if the output does not arrive within `timeout` simulated seconds.

        :param expected_output: a string, a compiled regular expression, or a list of them that must arrive in order.
        :param process: an action, or part of a launch name; None means any process.
        :param cmd_args: arguments that the process must have; see :func:`launch_testing.util.resolveProcesses`.
        :param stream: 'stdout' or 'stderr'. The default is 'stderr', where nodes log, as in ROS 2.
        :param options: further arguments of :func:`launch_testing.asserts.assertInStream`.
        """

        def has_come() -> bool:
            try:
                assertInStream(self, expected_output, process, cmd_args, stream=stream, **options)
            except (AssertionError, NoMatchingProcessException):
                return False
            return True

        return self._wait(has_come, timeout)

    def assertWaitFor(
        self,
        expected_output: Any,
        process: Any = None,
        cmd_args: CmdArgs = None,
        *,
        timeout: float = 10,
        stream: str = 'stderr',
        **options: Any,
    ) -> None:
        """Assert that output arrives; see :meth:`waitFor`.

        :raises AssertionError: when the output does not arrive in time.
        """
        if not self.waitFor(expected_output, process, cmd_args, timeout=timeout, stream=stream, **options):
            raise AssertionError(f'Waiting for output timed out\n  help: {self._advice(expected_output, stream, timeout)}')

    def _advice(self, expected_output: Any, stream: str, timeout: float) -> str:
        other = 'stdout' if stream == 'stderr' else 'stderr'
        if self.waitFor(expected_output, timeout=0, stream=other, strict_proc_matching=False):
            return f"{expected_output!r} was written to {other}; say stream='{other}'"
        pieces = [piece for piece in self if piece.from_stdout == (stream == 'stdout')]
        if not pieces:
            return f'nothing was written to {stream} within {timeout} s by: {", ".join(self.process_names()) or "any process"}'
        last = pieces[-1].text.decode(errors='replace').strip().split('\n')[-1]
        return f'{expected_output!r} did not come on {stream} within {timeout} s; the last line there was {last!r}'
