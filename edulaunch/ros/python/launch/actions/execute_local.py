"""The action `ExecuteLocal`."""

from __future__ import annotations

from functools import lru_cache
from typing import TYPE_CHECKING, Any

from .._bases import ReadOnly
from .._engine import environment
from ..action import Action
from ..descriptions.executable import Executable
from ..event_handlers.on_action_event_base import OnActionEventBase
from ..events.process.process_exited import ProcessExited
from ..launch_description_entity import LaunchDescriptionEntity
from ..substitution import SomeSubstitutionsType, Substitution
from ..substitutions.launch_configuration import LaunchConfiguration
from ..utilities.texts import normalize_to_list_of_substitutions, perform_substitutions
from ..utilities.type_utils import normalize_typed_substitution, perform_typed_substitution
from ._process_run import DEFAULT_OUTPUT_FORMAT, ProcessOptions

if TYPE_CHECKING:
    import asyncio

    from ..launch_context import LaunchContext
    from ._process_watch import ProcessWatch

SIGTERM_TIMEOUT = LaunchConfiguration('sigterm_timeout', default=5)
SIGKILL_TIMEOUT = LaunchConfiguration('sigkill_timeout', default=5)


class ExecuteLocal(Action):
    """Run a program. Its output and its end become events and log lines.

    :param process_description: the command line, working directory and environment.
    :param shell: whether a shell runs the joined command line.
    :param sigterm_timeout: the seconds between SIGINT and SIGTERM at shutdown.
    :param sigkill_timeout: the seconds between SIGTERM and SIGKILL at shutdown.
    :param emulate_tty: whether the program runs in a terminal. Simulated programs always print as in a terminal.
    :param output: 'log', 'screen', 'both', 'own_log', 'full', or a dictionary; see `launch.logging.get_output_loggers`.
        The environment variable OVERRIDE_LAUNCH_PROCESS_OUTPUT has priority.
    :param output_format: the format of lines on the screen. It may contain the fields `line` and `this` (this action).
    :param cached_output: whether to store the output for :meth:`get_stdout` and :meth:`get_stderr`.
    :param log_cmd: whether to log the command line.
    :param on_exit: what to do when the process has ended: an entity or several to visit, or a callable (event, context).
    :param respawn: whether to start the program again when it ends, until the launch is shut down.
    :param respawn_delay: the seconds between the end and the restart. None means no delay.
    :param respawn_max_retries: the maximum number of restarts. A negative number means no limit.
    """

    def __init__(
        self,
        *,
        process_description: Executable,
        shell: bool = False,
        sigterm_timeout: SomeSubstitutionsType = SIGTERM_TIMEOUT,
        sigkill_timeout: SomeSubstitutionsType = SIGKILL_TIMEOUT,
        emulate_tty: bool = False,
        output: Any = 'log',
        output_format: str = DEFAULT_OUTPUT_FORMAT,
        cached_output: bool = False,
        log_cmd: bool = False,
        on_exit: Any = None,
        respawn: bool | SomeSubstitutionsType = False,
        respawn_delay: float | None = None,
        respawn_max_retries: int = -1,
        **kwargs: Any,
    ) -> None:
        super().__init__(**kwargs)
        self.__process_description = process_description
        self.__sigterm_timeout: list[Substitution] = (
            [SIGTERM_TIMEOUT] if sigterm_timeout is SIGTERM_TIMEOUT else normalize_to_list_of_substitutions(sigterm_timeout)
        )
        self.__sigkill_timeout: list[Substitution] = (
            [SIGKILL_TIMEOUT] if sigkill_timeout is SIGKILL_TIMEOUT else normalize_to_list_of_substitutions(sigkill_timeout)
        )
        self.__output: Any = environment().get('OVERRIDE_LAUNCH_PROCESS_OUTPUT', output)
        if not isinstance(self.__output, (str, dict)):
            self.__output = normalize_to_list_of_substitutions(self.__output)
        self.__on_exit = on_exit
        if respawn is not False:
            respawn = normalize_typed_substitution(respawn, bool)
        self.__options = ProcessOptions(
            shell, emulate_tty, output_format, cached_output, log_cmd, respawn, respawn_delay, respawn_max_retries
        )

    __process_details: dict[str, Any] | None = None
    __watch: ProcessWatch | None = None
    __executed = False

    process_description: ReadOnly[Executable] = ReadOnly('The command line, working directory and environment.')

    @property
    def shell(self) -> bool:
        """Whether a shell runs the command line."""
        return bool(self.__options.shell)

    @property
    def emulate_tty(self) -> bool:
        """Whether the program runs in a terminal."""
        return bool(self.__options.emulate_tty)

    @property
    def respawn(self) -> Any:
        """Whether the program is started again when it ends. Before execution, this may be substitutions. (edulaunch only.)"""
        return self.__options.respawn

    respawn_delay: ReadOnly[Any] = ReadOnly('Seconds before a restart, or None. (edulaunch only.)', '__options.respawn_delay')

    @property
    def respawn_limit(self) -> int:
        """The maximum number of restarts, or a negative number for no limit. (edulaunch only.)"""
        return int(self.__options.respawn_max_retries)

    sigterm_timeout: ReadOnly[list[Substitution]] = ReadOnly('Seconds between SIGINT and SIGTERM, as substitutions.')
    sigkill_timeout: ReadOnly[list[Substitution]] = ReadOnly('Seconds between SIGTERM and SIGKILL, as substitutions.')

    @property
    def output(self) -> Any:
        """The target of the output: a dictionary or a name. Before execution, substitutions stand for the name."""
        is_given_name = isinstance(self.__output, str) and not self.__executed
        return normalize_to_list_of_substitutions(self.__output) if is_given_name else self.__output

    @property
    def process_details(self) -> dict[str, Any] | None:
        """The details of the process: `action`, `name`, `cmd`, `cwd` and `env`, and `pid` once the process runs. None before
        execution.
        """
        if self.__process_details is not None:
            self.__process_details['cmd'] = self.__process_description.final_cmd
        return self.__process_details

    @property
    def return_code(self) -> int | None:
        """The exit code of the last run; None before the first run has ended."""
        return None if self.__watch is None else self.__watch.return_code

    def get_stdout(self) -> str:
        """Return the standard output so far.

        :raises RuntimeError: when `cached_output` is not set.
        """
        return self.__cached_text('stdout')

    def get_stderr(self) -> str:
        """Return the standard error output so far.

        :raises RuntimeError: when `cached_output` is not set.
        """
        return self.__cached_text('stderr')

    def __cached_text(self, stream: str) -> str:
        if not self.__options.cached_output:
            raise RuntimeError(
                f"cached output must be true to be able to get {stream}, proc '{self.__process_description.final_name}'"
            )
        return '' if self.__watch is None else self.__watch.text_of(stream)

    def get_sub_entities(self) -> list[LaunchDescriptionEntity]:
        """Return the entities of `on_exit`. If `on_exit` is a callable, return an empty list."""
        return self.__on_exit if isinstance(self.__on_exit, list) else []

    def prepare(self, context: LaunchContext) -> None:
        """Evaluate all substitutions, and assign a number to the process."""
        description = self.__process_description
        description.prepare(context, self)
        self.__process_details = {
            'action': self,
            'name': description.final_name,
            'cmd': description.command,
            'cwd': description.final_cwd,
            'env': description.final_env,
        }
        if self.__options.respawn is not False:
            respawn = perform_typed_substitution(context, self.__options.respawn, bool)
            self.__options = self.__options._replace(respawn=respawn)

    def process_spec_details(self) -> dict[str, Any]:
        """Return further fields of the `ProcessSpec`, such as the package and executable of a node. Subclasses override it."""
        return {}

    def execute(self, context: LaunchContext) -> list[LaunchDescriptionEntity] | None:
        """Resolve the command line. The process starts after launch has visited all entities.

        :raises RuntimeError: when this action was executed before.
        """
        if self.__executed:
            raise RuntimeError(
                f"ExecuteLocal action '{self.__process_description.final_name}': executed more than once: {self.describe()}"
            )
        self.__executed = True
        self.prepare(context)
        if not context.is_shutdown:
            self.__schedule(context)
        return None

    def __schedule(self, context: LaunchContext) -> None:
        if not isinstance(self.__output, (str, dict)):
            self.__output = perform_substitutions(context, self.__output)
        assert self.__process_details is not None
        loop = context.asyncio_loop
        watch = _watch_type()(self, self.__process_details, self.__options, self.__output, loop)
        if self.__on_exit is not None:
            on_exit = OnActionEventBase(
                action_matcher=self, on_event=self.__on_exit, target_event_cls=ProcessExited, target_action_cls=ExecuteLocal
            )
            context.register_event_handler(on_exit)
        context.register_event_handler(watch)
        self.__watch = watch
        loop.call_soon(watch.begin, context)

    def start_again(self, context: LaunchContext) -> None:
        """Start the program again, even without `respawn`. A running program receives SIGINT first.

        Call this method on launch's loop. (edulaunch only.)
        """
        if self.__watch is not None:
            self.__watch.start_again(context)

    def get_asyncio_future(self) -> asyncio.Future[Any] | None:
        """Return a future that is done when the process has ended and will not be restarted. Return None before execution."""
        return None if self.__watch is None else self.__watch.completed


@lru_cache(maxsize=1)
def _watch_type() -> type[ProcessWatch]:
    """Import and return the class when the first process is scheduled, because the import takes time."""
    from ._process_watch import ProcessWatch

    return ProcessWatch
