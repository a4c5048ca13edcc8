"""What processes of a launch test wrote: `proc_output` of the tests."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

from launch.events.process import ProcessIO

from edulaunch.sim.sync import Condition

from .util.proc_lookup import CmdArgs, NoMatchingProcessException, process_name


class IoHandler:
    """Everything that was written, in order and by process."""

    def __init__(self) -> None:
        self._sequence: list[ProcessIO] = []
        self._by_action: dict[Any, list[ProcessIO]] = {}

    def append(self, process_io: ProcessIO) -> None:
        """Note a piece of output."""
        self._sequence.append(process_io)
        self._by_action.setdefault(process_io.action, []).append(process_io)

    def track(self, action: Any) -> None:
        """Note that a process has started; it may never write anything."""
        self._by_action.setdefault(action, [])

    def __iter__(self) -> Iterator[ProcessIO]:
        return iter(list(self._sequence))

    def __getitem__(self, key: Any) -> list[ProcessIO]:
        """The pieces of one process, by its action or by part of its name. Raises KeyError when there is none."""
        if isinstance(key, str):
            for action, pieces in self._by_action.items():
                if key in process_name(action):
                    return list(pieces)
            raise KeyError(key)
        return list(self._by_action[key])

    def processes(self) -> list[Any]:
        """The actions of the processes."""
        return list(self._by_action)

    def process_names(self) -> list[str]:
        """The launch names, such as 'talker-1'."""
        return [process_name(action) for action in self._by_action]


class ActiveIoHandler(IoHandler):
    """For tests that run while processes run: they can wait for output, in simulated time."""

    def __init__(self) -> None:
        super().__init__()
        self._changed = Condition()

    def append(self, process_io: ProcessIO) -> None:
        """Note a piece of output, and wake who waits for some."""
        with self._changed:
            super().append(process_io)
            self._changed.notify_all()

    def waitFor(
        self,
        expected_output: Any,
        process: Any = None,
        cmd_args: CmdArgs = None,
        *,
        timeout: float = 10,
        stream: str = 'stderr',
        output_filter: Callable[[str], str] | None = None,
        strict_proc_matching: bool = True,
        strip_ansi_escape_sequences: bool = True,
    ) -> bool:
        """Wait for output; False when it has not come after `timeout` simulated seconds.

        :param expected_output: a text, a compiled regular expression, or a list of them that must come in this order.
        :param process: an action, or part of a launch name; None: any process.
        :param cmd_args: narrows a name down, see :func:`launch_testing.util.resolveProcesses`.
        :param stream: 'stdout' or 'stderr'; as in ROS 2 the default is stderr, where nodes log.
        :param output_filter: changes what was written before it is compared.
        """
        from .asserts import assertInStream

        def has_come() -> bool:
            try:
                assertInStream(
                    self,
                    expected_output,
                    process,
                    cmd_args,
                    stream=stream,
                    output_filter=output_filter,
                    strict_proc_matching=strict_proc_matching,
                    strip_ansi_escape_sequences=strip_ansi_escape_sequences,
                )
            except (AssertionError, NoMatchingProcessException):
                return False
            return True

        with self._changed:
            return bool(self._changed.wait_for(has_come, timeout))

    def assertWaitFor(
        self,
        expected_output: Any,
        process: Any = None,
        cmd_args: CmdArgs = None,
        *,
        timeout: float = 10,
        stream: str = 'stderr',
        **kwargs: Any,
    ) -> None:
        """As :meth:`waitFor`.

        :raises AssertionError: when the output has not come in time.
        """
        if not self.waitFor(expected_output, process, cmd_args, timeout=timeout, stream=stream, **kwargs):
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
