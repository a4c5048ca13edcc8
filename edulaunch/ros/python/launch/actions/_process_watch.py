"""Watches a process after its action was executed: its start, output, signals, restarts and end."""

from __future__ import annotations

import errno
import os
import signal
from functools import cached_property
from traceback import format_exception_only
from typing import TYPE_CHECKING, Any

from .._engine import assumptions, running_process
from ..conditions.evaluate_condition_expression_impl import evaluate_condition_expression
from ..event import Event
from ..event_handler import BaseEventHandler
from ..events.process.process_exited import ProcessExited
from ..events.process.process_io import ProcessIO
from ..events.process.process_started import ProcessStarted
from ..events.process.process_stderr import ProcessStderr
from ..events.process.process_stdout import ProcessStdout
from ..events.process.process_targeted_event import ProcessTargetedEvent
from ..events.process.running_process_event import RunningProcessEvent
from ..events.process.shutdown_process import ShutdownProcess
from ..events.process.signal_process import SignalProcess
from ..events.shutdown import Shutdown
from ..launch_description_entity import LaunchDescriptionEntity
from ..logging import get_logger, get_output_loggers
from ..logging._output import normalize_output_configuration
from ..utilities.texts import normalize_to_list_of_substitutions
from ._process_run import DEFAULT_OUTPUT_FORMAT, OutputLines, ProcessRun

if TYPE_CHECKING:
    import asyncio
    from collections.abc import Callable

    from ..launch_context import LaunchContext
    from ._process_run import ProcessOptions, ProcessRun
    from .execute_local import ExecuteLocal

Entities = list[LaunchDescriptionEntity]
PATIENCE = 1000
SHORTEST_LIFE_S = 0.25
"""Simulated seconds until the next start of a program that ended at the time of its start. On a real computer, Python needs about
as long. Without it, a program with `respawn` and a missing module would start forever at one simulated time.
"""


class ProcessWatch(BaseEventHandler):
    """Runs the program of one action, and handles all events for this program.

    :param details: the `process_details` of the action; `pid` is added when the process runs.
    :ivar completed: a future that is done when the process has ended and will not be restarted.
    :ivar return_code: the exit code of the last run; None before the first run has ended.
    """

    def __init__(
        self, action: ExecuteLocal, details: dict[str, Any], options: ProcessOptions, output: Any, loop: asyncio.AbstractEventLoop
    ) -> None:
        super().__init__(matcher=self._concerns)
        self.only_action = action
        self._action = action
        self._details = details
        self._options = options
        self._run: ProcessRun | None = None
        self._retries = 0
        self._loop = loop
        self._is_asked_to_end = self._is_wanted_again = False
        self._respawn: asyncio.TimerHandle | None = None
        self._began_s = 0.0
        self._ends_on_start: bool | None = None
        self._timers: list[Any] = []
        self.completed: asyncio.Future[None] = loop.create_future()
        self.return_code: int | None = None
        self._output = output
        if output != 'log':
            normalize_output_configuration(output)
        self._lines: dict[str, OutputLines] = {}
        self._unshown = 0

    @cached_property
    def _logger(self) -> Any:
        return get_logger(self._details['name'])

    def text_of(self, stream: str) -> str:
        """Return the output so far on the stream 'stdout' or 'stderr'."""
        lines = self._lines.get(stream)
        return '' if lines is None else lines.text

    def _lines_of(self, stream: str) -> OutputLines:
        """Return the line splitter of a stream. It is created at the first output, because many programs never print."""
        lines = self._lines.get(stream)
        if lines is None:
            stdout, stderr = get_output_loggers(self._details['name'], self._output)
            printer = self._line_printer(stdout if stream == 'stdout' else stderr)
            lines = self._lines[stream] = OutputLines(printer, self._options.cached_output)
        return lines

    def _line_printer(self, logger: Any) -> Callable[[str], object]:
        info, template, action = logger.info, self._options.output_format, self._action
        if template == DEFAULT_OUTPUT_FORMAT:
            prefix = f'[{self._details["name"]}] '
            return lambda line: info(prefix + line)
        return lambda line: info(template.format(line=line, this=action))

    # -- running

    def begin(self, context: LaunchContext) -> None:
        """Start the program, unless launch has cancelled all starts that have not happened yet. Launch's loop calls this method.

        An error here ends the action, and the launch service reports the error.
        """
        self._respawn = None
        self._began_s = self._loop.time()
        if context.starts_are_abandoned:
            self._finish()
            return
        try:
            self._begin(context)
        except Exception as error:
            self._finish(error)

    def _begin(self, context: LaunchContext) -> None:
        details = self._details
        if self._options.log_cmd:
            self._logger.info(
                f"process details: cmd='{self._shown_command()}', cwd='{details['cwd']}', "
                f'custom_env?={details["env"] is not None}'
            )
        emulate_tty = _wants_terminal(context, self._options)
        try:
            self._run = self._start(context, emulate_tty)
        except Exception as error:
            self._logger.error(f'exception occurred while executing process:\n{start_failure(error, self._action, details)}')
            self._finish()
            return
        pid = details['pid'] = self._run.pid
        self._logger.info(f'process started with pid [{pid}]')
        context.emit_event_sync(ProcessStarted(**details))
        self._run.complete.add_done_callback(lambda complete: self._end(context, complete.result()))

    def _end(self, context: LaunchContext, returncode: int, patience: int = PATIENCE) -> None:
        """Log the end of the program if its output goes to the screen, and start the program again if requested.

        :param patience: the number of further rounds of the loop in which to wait for output events, because launch handles none
            after the end.
        """
        if self._unshown and patience:
            self._loop.call_soon(self._end, context, returncode, patience - 1)
            return
        self.return_code = returncode
        pid = self._details['pid']
        if returncode == 0:
            self._logger.info(f'process has finished cleanly [pid {pid}]')
        else:
            self._logger.error(f"process has died [pid {pid}, exit code {returncode}, cmd '{self._shown_command()}'].")
        context.emit_event_sync(ProcessExited(returncode=returncode, **self._details))
        try:
            self._start_again_or_finish(context)
        except TypeError as error:  # a delay or a number of retries that is not a number
            self._finish(error)

    def start_again(self, context: LaunchContext) -> None:
        """Implement `ExecuteLocal.start_again`."""
        if context.is_shutdown or self._is_asked_to_end or self._run is None:
            return
        if not self._run.complete.done():
            self._is_wanted_again = True
            self._logger.info(f"sending signal 'SIGINT' to process[{self._details['name']}]")
            self._run.send_signal(signal.SIGINT)
        elif self._respawn is None:
            if self.completed.done():
                self.completed = self._loop.create_future()
                context.add_completion_future(self.completed)
            self.begin(context)

    def _start_again_or_finish(self, context: LaunchContext) -> None:
        options = self._options
        if self._is_wanted_again and not context.is_shutdown:
            self._is_wanted_again = False
            self.begin(context)
            return
        if context.is_shutdown or self._is_asked_to_end or not options.wants_respawn(self._retries):
            self._finish()
            return
        self._retries += 1
        if options.has_delay:
            self._respawn = self._loop.call_later(options.respawn_delay, self.begin, context)
        elif self._loop.time() == self._began_s:
            self._respawn = self._loop.call_later(SHORTEST_LIFE_S, self.begin, context)
        else:
            self.begin(context)

    def _finish(self, error: Exception | None = None) -> None:
        """End the action: mark its future as done."""
        if not self.completed.done():
            if error is None:
                self.completed.set_result(None)
            else:
                self.completed.set_exception(error)
        for timer in self._timers:
            timer.cancel()

    def _shown_command(self) -> str:
        return ' '.join(part for part in self._details['cmd'] if part.strip())

    def _start(self, context: LaunchContext, emulate_tty: bool) -> ProcessRun:
        from edulaunch.engine.processes import ProcessSpec

        details = self._details
        details['cmd'] = self._action.process_description.command
        folder = details['cwd']
        if folder and assumptions() is None and not os.path.isdir(running_process().path(folder)):
            raise FileNotFoundError(errno.ENOENT, os.strerror(errno.ENOENT), folder)
        spec = ProcessSpec(
            argv=tuple(details['cmd']),
            name=details['name'],
            cwd=details['cwd'],
            env=details['env'],
            shell=self._options.shell,
            emulate_tty=emulate_tty,
            origin=self._action.origin,
            has_pipe=True,
            **self._action.process_spec_details(),
        )

        def on_output(stream: str, text: str) -> None:
            self._unshown += 1
            event_type = ProcessStdout if stream == 'stdout' else ProcessStderr
            context.emit_event_sync(event_type(text=text.encode('utf-8', 'surrogateescape'), **details))

        return ProcessRun(context.asyncio_loop, spec, on_output)

    # -- events

    def _concerns(self, event: Event) -> bool:
        if isinstance(event, ProcessTargetedEvent):
            return event.process_matcher(self._action)
        # Ignore the action's other events: with a handler for ExecutionComplete, launch emits it once for each process.
        return isinstance(event, Shutdown) or (isinstance(event, RunningProcessEvent) and event.action is self._action)

    def handle(self, event: Event, context: LaunchContext) -> Entities | None:
        """Handle an event that this process emitted, or that targets this process. Return the entities to visit, or None."""
        super().handle(event, context)
        if isinstance(event, ProcessIO):
            self._unshown -= 1
            self._on_io(event)
        elif isinstance(event, ProcessExited):
            for stream in sorted(self._lines, reverse=True):
                self._lines[stream].flush()
        elif isinstance(event, SignalProcess):
            self._on_signal(event)
        elif isinstance(event, ShutdownProcess):
            return self._shut_down(context, send_sigint=True)
        elif isinstance(event, Shutdown):
            # After Ctrl-C in a terminal, the terminal itself has already sent SIGINT to the process.
            return self._shut_down(context, send_sigint=not event.due_to_sigint or context.noninteractive)
        elif isinstance(event, ProcessStarted) and self._ends_on_start is not None:
            return self._shut_down(context, send_sigint=self._ends_on_start)
        return None

    def _on_io(self, event: ProcessIO) -> None:
        if event.from_stdin:
            self._logger.warning(f"in ExecuteProcess('{self._details['name']}').__on_process_stdin_event()")
        else:
            self._lines_of('stdout' if event.from_stdout else 'stderr').write(event.text)

    def _on_signal(self, event: SignalProcess) -> None:
        from edulaunch.engine.processes.spec import Signals

        if self._run is None:
            raise RuntimeError('Signal event received before subprocess transport available.')
        name = self._details['name']
        if self._run.complete.done():
            self._logger.debug(f"signal '{event.signal_name}' not sent to '{name}' because it is already closing")
            return
        self._logger.info(f"sending signal '{event.signal_name}' to process[{name}]")
        if isinstance(event.signal, str) and event.signal != 'SIGKILL':
            raise TypeError("'str' object cannot be interpreted as an integer")
        self._run.send_signal(Signals[event.signal_name])

    def _shut_down(self, context: LaunchContext, *, send_sigint: bool) -> Entities | None:
        """Send the first signal to the process, and return the timers that send stronger signals."""
        if self._is_asked_to_end or self.completed.done():
            return None
        if self._run is None:
            self._ends_on_start = send_sigint
            return None
        from edulaunch.engine.processes.spec import Signals

        from ._escalation import escalation_timers, request_signal

        self._is_asked_to_end = True
        if self._respawn is not None:
            self._respawn.cancel()
            self._loop.call_soon(self._finish)
        context.extend_locals({'process_name': self._details['name']})
        self._timers = escalation_timers(self._action, self._logger)
        return [*self._timers, *([request_signal(self._action, Signals.SIGINT)] if send_sigint else [])]


def _wants_terminal(context: LaunchContext, options: ProcessOptions) -> bool:
    """Return whether the program runs in a terminal: the launch configuration `emulate_tty`, or else the action's setting.

    The launch configuration must be a boolean.
    """
    wanted = context.launch_configurations.get('emulate_tty')
    if wanted is None:
        return bool(options.emulate_tty)
    return evaluate_condition_expression(context, normalize_to_list_of_substitutions(wanted))


def start_failure(error: Exception, action: ExecuteLocal, details: dict[str, Any]) -> str:
    """Return the last line of Python's report about `error`, and a line of help with the place of the action.

    ROS 2 shows a traceback of launch instead, which contains no code of the student.
    """
    text = ''.join(format_exception_only(error)).rstrip()
    origin = action.origin
    place = '' if origin is None else f'{running_process().index.source_path(origin.file)}:{origin.line}: '
    advice = _advice(error, details)
    return f'{text}\n  help: {place}{advice}' if place or advice else text


def _advice(error: Exception, details: dict[str, Any]) -> str:
    program, folder = details['cmd'][0], details['cwd']
    if folder and not os.path.isdir(folder):
        return f'the folder of cwd={folder!r} does not exist; create it, or write the path of another folder'
    if isinstance(error, FileNotFoundError):
        if len(details['cmd']) > 1 and all(len(word) == 1 for word in details['cmd']):
            return 'cmd is one text, of which each letter became a word: put it into a list, cmd=[[...]] with shell=True'
        blank = '; write each argument as an item of cmd of its own, or shell=True' if ' ' in program else ''
        where = 'there is no such file' if os.sep in program else f'there is no program {program!r} on the PATH'
        return where + blank
    if isinstance(error, PermissionError):
        return f'{program!r} is not executable: chmod +x it'
    return 'this program could not be started'
