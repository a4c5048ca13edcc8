"""Running a program and watching it."""
from __future__ import annotations

import signal
from typing import TYPE_CHECKING, Any

from .._engine import environment
from ..action import Action
from ..conditions.evaluate_condition_expression_impl import evaluate_condition_expression
from ..descriptions.executable import Executable
from ..event import Event
from ..event_handler import BaseEventHandler, EventHandler
from ..event_handlers.on_process_exit import OnProcessExit
from ..event_handlers.on_process_io import OnProcessIO
from ..event_handlers.on_process_start import OnProcessStart
from ..event_handlers.on_shutdown import OnShutdown
from ..events.process.process_exited import ProcessExited
from ..events.process.process_io import ProcessIO
from ..events.process.process_started import ProcessStarted
from ..events.process.process_stderr import ProcessStderr
from ..events.process.process_stdout import ProcessStdout
from ..events.process.process_targeted_event import ProcessTargetedEvent
from ..events.process.shutdown_process import ShutdownProcess
from ..events.process.signal_process import SignalProcess
from ..events.shutdown import Shutdown
from ..launch_description_entity import LaunchDescriptionEntity
from ..some_substitutions_type import SomeSubstitutionsType
from ..substitution import Substitution
from ..substitutions.launch_configuration import LaunchConfiguration
from ..utilities.normalize_to_list_of_substitutions_impl import normalize_to_list_of_substitutions
from ..utilities.perform_substitutions_impl import perform_substitutions
from ..utilities.type_utils import is_substitution, normalize_typed_substitution, perform_typed_substitution
from ._output_lines import OutputLines
from .opaque_function import OpaqueFunction

if TYPE_CHECKING:
    import asyncio

    from ..launch_context import LaunchContext
    from ._process_run import ProcessRun

DEFAULT_OUTPUT_FORMAT = '[{this.process_description.final_name}] {line}'


class ExecuteLocal(Action):
    """Run a program. What it prints and how it ends become events and log lines.

    :param process_description: the command line and what belongs to it.
    :param shell: let a shell run the joined command line.
    :param sigterm_timeout, sigkill_timeout: seconds between SIGINT and SIGTERM, and then SIGKILL, at shutdown.
    :param emulate_tty: run in a terminal; programs here print as if in one anyway.
    :param output: 'log', 'screen', 'both', 'own_log', 'full', or a dictionary; see `launch.logging.get_output_loggers`.
        OVERRIDE_LAUNCH_PROCESS_OUTPUT in the environment comes first.
    :param output_format: of lines on the screen; may use `line` and `this` (this action).
    :param cached_output: keep what is printed, for :meth:`get_stdout` and :meth:`get_stderr`.
    :param log_cmd: log the command line.
    :param on_exit: an entity, several, or a callable (event, context), for when the process has ended.
    :param respawn: start it again whenever it ends, `respawn_delay` seconds later, at most `respawn_max_retries` times
        (negative: without limit), until the launch is shut down.
    """

    def __init__(self, *, process_description: Executable, shell: bool = False,
                 sigterm_timeout: SomeSubstitutionsType = LaunchConfiguration('sigterm_timeout', default=5),
                 sigkill_timeout: SomeSubstitutionsType = LaunchConfiguration('sigkill_timeout', default=5),
                 emulate_tty: bool = False, output: Any = 'log', output_format: str = DEFAULT_OUTPUT_FORMAT,
                 cached_output: bool = False, log_cmd: bool = False, on_exit: Any = None,
                 respawn: bool | SomeSubstitutionsType = False, respawn_delay: float | None = None,
                 respawn_max_retries: int = -1, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        self.__process_description = process_description
        self.__shell = shell
        self.__sigterm_timeout = normalize_to_list_of_substitutions(sigterm_timeout)
        self.__sigkill_timeout = normalize_to_list_of_substitutions(sigkill_timeout)
        self.__emulate_tty = emulate_tty
        self.__output: Any = environment().get('OVERRIDE_LAUNCH_PROCESS_OUTPUT', output)
        if not isinstance(self.__output, dict):
            self.__output = normalize_to_list_of_substitutions(self.__output)
        self.__output_format = output_format
        self.__cached_output = cached_output
        self.__log_cmd = log_cmd
        self.__on_exit = on_exit
        self.__respawn = normalize_typed_substitution(respawn, bool)
        self.__respawn_delay = respawn_delay
        self.__respawn_max_retries = respawn_max_retries
        self.__respawn_retries = 0
        self.__process_event_args: dict[str, Any] | None = None
        self.__run: ProcessRun | None = None
        self.__completed_future: asyncio.Future[None] | None = None
        self.__shutdown_future: asyncio.Future[None] | None = None
        self.__shutdown_timers: list[Any] = []
        self.__return_code: int | None = None
        self.__executed = False
        self.__logger: Any = None
        self.__stdout: OutputLines | None = None
        self.__stderr: OutputLines | None = None

    @property
    def process_description(self) -> Executable:
        """The command line and what belongs to it."""
        return self.__process_description

    @property
    def shell(self) -> bool:
        """Whether a shell runs the command line."""
        return self.__shell

    @property
    def emulate_tty(self) -> bool:
        """Whether the program is to run in a terminal."""
        return self.__emulate_tty

    @property
    def sigterm_timeout(self) -> list[Substitution]:
        """Seconds between SIGINT and SIGTERM, as substitutions."""
        return self.__sigterm_timeout

    @property
    def sigkill_timeout(self) -> list[Substitution]:
        """Seconds between SIGTERM and SIGKILL, as substitutions."""
        return self.__sigkill_timeout

    @property
    def output(self) -> Any:
        """Where the output goes: a dictionary, or substitutions for a name."""
        return self.__output

    @property
    def process_details(self) -> dict[str, Any] | None:
        """None before execution, then `action`, `name`, `cmd`, `cwd`, `env`, and once it runs `pid`."""
        return self.__process_event_args

    @property
    def return_code(self) -> int | None:
        """The exit code of the last run; None before."""
        return self.__return_code

    def get_stdout(self) -> str:
        """What was written to the standard output so far.

        :raises RuntimeError: without `cached_output`.
        """
        return self.__cached_text(self.__stdout, 'stdout')

    def get_stderr(self) -> str:
        """What was written to the standard error so far.

        :raises RuntimeError: without `cached_output`.
        """
        return self.__cached_text(self.__stderr, 'stderr')

    def __cached_text(self, lines: OutputLines | None, stream: str) -> str:
        if not self.__cached_output:
            raise RuntimeError(f'cached output must be true to be able to get {stream}, '
                               f"proc '{self.__process_description.final_name}'")
        return '' if lines is None else lines.text

    def get_sub_entities(self) -> list[LaunchDescriptionEntity]:
        """The entities of `on_exit`, when it is a list."""
        return self.__on_exit if isinstance(self.__on_exit, list) else []

    # -- execution

    def prepare(self, context: LaunchContext) -> None:
        """Evaluate all substitutions; the process gets its number."""
        description = self.__process_description
        description.prepare(context, self)
        self.__process_event_args = {
            'action': self, 'name': description.final_name, 'cmd': description.final_cmd,
            'cwd': description.final_cwd, 'env': description.final_env}
        self.__respawn = perform_typed_substitution(context, self.__respawn, bool)
        self.__respawn_delay = _performed(context, self.__respawn_delay, float)
        self.__respawn_max_retries = _performed(context, self.__respawn_max_retries, int)
        self.__shell = _performed(context, self.__shell, bool)
        self.__emulate_tty = _performed(context, self.__emulate_tty, bool)

    def _process_spec_details(self) -> dict[str, Any]:
        """Further fields of the `ProcessSpec`; a node says which package and executable it is. For subclasses."""
        return {}

    def execute(self, context: LaunchContext) -> list[LaunchDescriptionEntity] | None:
        """Resolve the command line now; the process starts after everything has been visited.

        :raises RuntimeError: when this action was executed before.
        """
        self.prepare(context)
        name = self.__process_description.final_name
        assert name is not None
        if self.__executed:
            raise RuntimeError(f"ExecuteLocal action '{name}': executed more than once: {self.describe()}")
        self.__executed = True
        if context.is_shutdown:
            return None
        handlers = self.__event_handlers()
        for handler in handlers:
            context.register_event_handler(handler)
        try:
            self.__schedule(context, name)
        except Exception:
            for handler in handlers:
                context.unregister_event_handler(handler)
            raise
        return None

    def __schedule(self, context: LaunchContext, name: str) -> None:
        from ..logging import get_logger, get_output_loggers
        loop = context.asyncio_loop
        self.__completed_future = loop.create_future()
        self.__shutdown_future = loop.create_future()
        self.__logger = get_logger(name)
        if not isinstance(self.__output, dict):
            self.__output = perform_substitutions(context, self.__output)
        stdout_logger, stderr_logger = get_output_loggers(name, self.__output)
        self.__stdout = OutputLines(self.__line_printer(stdout_logger, name), self.__cached_output)
        self.__stderr = OutputLines(self.__line_printer(stderr_logger, name), self.__cached_output)
        loop.create_task(self.__watched(context))

    def __line_printer(self, logger: Any, name: str) -> Any:
        info, template = logger.info, self.__output_format
        if template == DEFAULT_OUTPUT_FORMAT:
            prefix = f'[{name}] '
            return lambda line: info(prefix + line)
        return lambda line: info(template.format(line=line, this=self))

    def __event_handlers(self) -> list[BaseEventHandler]:
        return [
            _TargetedEventHandler(self, ShutdownProcess, self.__on_shutdown_process_event),
            _TargetedEventHandler(self, SignalProcess, self.__on_signal_process_event),
            OnProcessIO(target_action=self, on_stdin=self.__on_process_stdin, on_stdout=self.__on_process_output,
                        on_stderr=self.__on_process_output),
            OnShutdown(on_shutdown=self.__on_shutdown),
            OnProcessExit(target_action=self, on_exit=self.__on_exit),
            OnProcessExit(target_action=self, on_exit=self.__flush_buffers)]

    async def __watched(self, context: LaunchContext) -> None:
        """Run the program; a mistake on the way ends this action, and the launch service reports it."""
        try:
            if not context._starts_are_abandoned:
                await self.__execute_process(context)
            self.__cleanup()
        except Exception as error:
            assert self.__completed_future is not None
            if not self.__completed_future.done():
                self.__completed_future.set_exception(error)

    async def __execute_process(self, context: LaunchContext) -> None:
        while True:
            returncode = await self.__run_once(context)
            if returncode is None or not await self.__is_to_respawn(context):
                return

    async def __run_once(self, context: LaunchContext) -> int | None:
        """Start the program and wait for its end; None when it cannot be started."""
        args = self.__process_event_args
        assert args is not None
        shown = ' '.join(part for part in args['cmd'] if part.strip())
        if self.__log_cmd:
            self.__logger.info(f"process details: cmd='{shown}', cwd='{args['cwd']}', "
                               f"custom_env?={args['env'] is not None}")
        self.__check_emulate_tty(context)
        try:
            self.__run = self.__start(context, args)
        except Exception:
            import traceback
            self.__logger.error(f'exception occurred while executing process:\n{traceback.format_exc()}')
            return None
        pid = args['pid'] = self.__run.pid
        self.__logger.info(f'process started with pid [{pid}]')
        await context.emit_event(ProcessStarted(**args))
        returncode = await self.__run.complete
        if returncode == 0:
            self.__logger.info(f'process has finished cleanly [pid {pid}]')
        else:
            self.__logger.error(f"process has died [pid {pid}, exit code {returncode}, cmd '{shown}'].")
        self.__return_code = returncode
        await context.emit_event(ProcessExited(returncode=returncode, **args))
        return returncode

    def __start(self, context: LaunchContext, args: dict[str, Any]) -> ProcessRun:
        from edulaunch.processes import ProcessSpec

        from ._process_run import ProcessRun
        spec = ProcessSpec(argv=tuple(args['cmd']), name=args['name'], cwd=args['cwd'], env=args['env'],
                           shell=self.__shell, origin=self.origin, **self._process_spec_details())

        def on_output(stream: str, text: str) -> None:
            event_type = ProcessStdout if stream == 'stdout' else ProcessStderr
            context.emit_event_sync(event_type(text=text.encode('utf-8', 'surrogateescape'), **args))

        return ProcessRun(context.asyncio_loop, spec, on_output)

    def __check_emulate_tty(self, context: LaunchContext) -> None:
        wanted = context.launch_configurations.get('emulate_tty')
        if wanted is not None:
            self.__emulate_tty = evaluate_condition_expression(context, normalize_to_list_of_substitutions(wanted))

    async def __is_to_respawn(self, context: LaunchContext) -> bool:
        """Whether the program is to be started again; waits for the delay."""
        assert self.__shutdown_future is not None
        if context.is_shutdown or self.__shutdown_future.done() or not self.__respawn:
            return False
        if 0 <= self.__respawn_max_retries <= self.__respawn_retries:
            return False
        self.__respawn_retries += 1
        if self.__respawn_delay is not None and self.__respawn_delay > 0.0:
            import asyncio
            await asyncio.wait([self.__shutdown_future], timeout=self.__respawn_delay)
        return not self.__shutdown_future.done()

    def __cleanup(self) -> None:
        for timer in self.__shutdown_timers:
            timer.cancel()
        assert self.__completed_future is not None
        self.__completed_future.set_result(None)

    def get_asyncio_future(self) -> asyncio.Future[Any] | None:
        """Done when the process has ended for good."""
        return self.__completed_future

    # -- reactions

    def __on_process_stdin(self, event: ProcessIO) -> None:
        self.__logger.warning(f"in ExecuteProcess('{self.__process_description.final_name}').__on_process_stdin_event()")

    def __on_process_output(self, event: ProcessIO) -> None:
        lines = self.__stdout if event.from_stdout else self.__stderr
        assert lines is not None
        lines.write(event.text)

    def __flush_buffers(self, event: Event, context: LaunchContext) -> None:
        assert self.__stdout is not None and self.__stderr is not None
        self.__stdout.flush()
        self.__stderr.flush()

    def __on_shutdown(self, event: Shutdown, context: LaunchContext) -> list[LaunchDescriptionEntity] | None:
        # After ctrl-c in a terminal the terminal has sent SIGINT to the process already.
        return self._shutdown_process(context, send_sigint=not event.due_to_sigint or context.noninteractive)

    def __on_shutdown_process_event(self, context: LaunchContext) -> list[LaunchDescriptionEntity] | None:
        return self._shutdown_process(context, send_sigint=True)

    def _shutdown_process(self, context: LaunchContext, *, send_sigint: bool) -> list[LaunchDescriptionEntity] | None:
        """Begin to end the process: the entities to visit (timers for stronger signals, and the first signal)."""
        from ._escalation import escalation_timers, send_signal
        if self.__shutdown_future is None or self.__shutdown_future.done():
            return None
        if self.__completed_future is None or self.__completed_future.done():
            return None
        assert self.__process_event_args is not None
        if 'pid' not in self.__process_event_args:
            context.register_event_handler(OnProcessStart(
                on_start=lambda event, context: self._shutdown_process(context, send_sigint=send_sigint),
                target_action=lambda action: action is self, handle_once=True))
            return None
        self.__shutdown_future.set_result(None)
        context.extend_locals({'process_name': self.__process_event_args['name']})
        self.__shutdown_timers = escalation_timers(self, self.__logger)
        return [*self.__shutdown_timers, *([send_signal(self, signal.SIGINT)] if send_sigint else [])]

    def __on_signal_process_event(self, context: LaunchContext) -> None:
        event: SignalProcess = context.locals.event
        if self.__run is None or self.__process_event_args is None:
            raise RuntimeError('Signal event received before subprocess transport available.')
        name = self.__process_event_args['name']
        if self.__run.complete.done():
            self.__logger.debug(f"signal '{event.signal_name}' not sent to '{name}' because it is already closing")
            return
        self.__logger.info(f"sending signal '{event.signal_name}' to process[{name}]")
        self.__run.send_signal(event.signal)


class _TargetedEventHandler(EventHandler):
    """Handles the targeted events of one type that mean this action."""

    def __init__(self, action: ExecuteLocal, event_type: type[ProcessTargetedEvent], function: Any) -> None:
        def matches(event: Event) -> bool:
            return isinstance(event, event_type) and event.process_matcher(action)

        super().__init__(matcher=matches, entities=OpaqueFunction(function=function))
        self._event_types = (event_type,)


def _performed(context: LaunchContext, value: Any, data_type: type) -> Any:
    """A value that frontends may give as substitutions; anything else as it is."""
    if value is None or isinstance(value, (int, float)) or not is_substitution(value):
        return value
    return perform_typed_substitution(context, normalize_to_list_of_substitutions(value), data_type)
