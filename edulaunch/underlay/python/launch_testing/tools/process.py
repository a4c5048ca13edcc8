"""Starting a process from inside a test."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any

from launch.actions.execute_local import ExecuteLocal
from launch.events.matchers import matches_action
from launch.events.process.process_exited import ProcessExited
from launch.events.process.shutdown_process import ShutdownProcess
from launch.launch_description import LaunchDescription

if TYPE_CHECKING:
    from launch.launch_service import LaunchService

    from ..io_handler import ActiveIoHandler
    from ..proc_info_handler import ActiveProcInfoHandler


class ProcessProxy:
    """One process, as a test sees it. Waiting takes simulated time.

    :param output_filter: changes what the process wrote before it is given out.
    """

    def __init__(
        self,
        process_action: ExecuteLocal,
        proc_info: ActiveProcInfoHandler,
        proc_output: ActiveIoHandler,
        *,
        output_filter: Callable[[str], str] | None = None,
    ) -> None:
        self._action = process_action
        self._proc_info = proc_info
        self._proc_output = proc_output
        self._output_filter = output_filter

    def wait_for_shutdown(self, timeout: float = 10) -> bool:
        """Wait for the end; False when it has not come in time."""
        try:
            self._proc_info.assertWaitForShutdown(self._action, timeout=timeout)
        except AssertionError:
            return False
        return True

    def wait_for_output(self, condition: Callable[[str], bool] | None = None, *, timeout: float | None = None) -> bool:
        """Wait until `condition(output)` holds (None: until there is any); False when it does not in time."""
        holds = bool if condition is None else condition
        with self._proc_output._changed:
            return bool(self._proc_output._changed.wait_for(lambda: holds(self.output), timeout))

    @property
    def output(self) -> str:
        """All that was written, on both streams."""
        return self._text(lambda piece: True)

    @property
    def stdout(self) -> str:
        """What was written to the standard output."""
        return self._text(lambda piece: bool(piece.from_stdout))

    @property
    def stderr(self) -> str:
        """What was written to the standard error."""
        return self._text(lambda piece: bool(piece.from_stderr))

    def _text(self, wanted: Callable[[Any], bool]) -> str:
        pieces = self._proc_output[self._action] if self._action in self._proc_output.processes() else []
        text = b''.join(piece.text for piece in pieces if wanted(piece)).decode(errors='replace')
        return text if self._output_filter is None else self._output_filter(text)

    @property
    def running(self) -> bool:
        """Whether it has started and not ended."""
        return self._action in self._proc_info.processes() and not self.terminated

    @property
    def terminated(self) -> bool:
        """Whether it has ended."""
        return self._action in self._proc_info.processes() and isinstance(self._proc_info[self._action], ProcessExited)

    @property
    def exit_code(self) -> int | None:
        """The return code; None before the end."""
        return getattr(self._proc_info[self._action], 'returncode', None) if self.terminated else None


@contextmanager
def launch_process(
    launch_service: LaunchService,
    process_action: ExecuteLocal,
    proc_info: ActiveProcInfoHandler,
    proc_output: ActiveIoHandler,
    **kwargs: Any,
) -> Iterator[ProcessProxy]:
    """Run a process inside a `with` block; at its end the process is asked to end, and waited for.

    :param kwargs: those of :class:`ProcessProxy`.
    :raises AssertionError: when the process does not start, or does not end.
    """
    launch_service.include_launch_description(LaunchDescription([process_action]))
    proc_info.assertWaitForStartup(process_action)
    proxy = ProcessProxy(process_action, proc_info, proc_output, **kwargs)
    try:
        yield proxy
    finally:
        if not proxy.terminated:
            launch_service.emit_event(ShutdownProcess(process_matcher=matches_action(process_action)))
            proc_info.assertWaitForShutdown(process_action)
