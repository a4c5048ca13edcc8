"""The state of a running launch."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterable, MutableMapping
from typing import TYPE_CHECKING, Any, NoReturn, Protocol

from edulaunch.ros.read_only import ReadOnly

from ._engine import environment, process_state, running_process
from ._handler_table import Handler, HandlerTable
from ._run_notes import names_read
from .event import Event

if TYPE_CHECKING:
    import asyncio
    from logging import Logger

    from ._event_queue import EventQueue
    from ._include_ring import Include
    from ._observer import Observer


class Performed(Protocol):
    """The part of a substitution that a context needs."""

    def perform(self, context: LaunchContext) -> str:
        """Return the string that the substitution evaluates to."""


class LocalsView:
    """Gives access to a dictionary through attributes.

    :raises AttributeError: for an unknown name, with a list of the known names, and on every attempt to set an attribute.
    """

    def __init__(self, values: dict[str, Any]) -> None:
        object.__setattr__(self, '_values', values)

    def __getattr__(self, name: str) -> Any:
        values: dict[str, Any] = object.__getattribute__(self, '_values')
        if name not in values:
            raise AttributeError(f"context.locals does not contain attribute '{name}', it contains: [{', '.join(values)}]")
        return values[name]

    def __setattr__(self, name: str, value: Any) -> NoReturn:
        raise AttributeError("can't set attribute, locals are read-only")


class LaunchContext:
    """The launch configurations, locals, environment, event handlers and waiting events of one launch.

    :param argv: the command line arguments, for code that reads `argv`.
    :param noninteractive: whether no terminal is attached. If so, launch must pass Ctrl-C on to the processes.
    """

    def __init__(self, *, argv: Iterable[str] | None = None, noninteractive: bool = False) -> None:
        self.__argv = list(argv) if argv is not None else []
        self.__noninteractive = noninteractive
        self.__handlers = HandlerTable()
        self.__event_queue: EventQueue | None = None
        self.__completion_futures: list[asyncio.Future[Any]] = []
        self.__globals: dict[str, Any] = {}
        self.__locals: dict[str, Any] = {}
        self.__locals_stack: list[dict[str, Any]] = []
        self.__environment = environment()
        self.__environment_at_start = dict(self.__environment)
        self.__environment_stack: list[dict[str, str]] = []
        self.__launch_configurations: dict[str, Any] = {}
        self.__launch_configurations_stack: list[dict[str, Any]] = []
        self.open_includes: list[Include] | None = None
        """The launch files that are being visited, outermost first; None outside any walk."""
        self.observer: Observer | None = None
        """Receives the visits and events of the launch service. (edulaunch only.)"""
        self._names_read = names_read()
        self.process_state = running_process().state
        self.process_counter = process_state('launch.process_counter', lambda: [0])
        self.__is_shutdown = False
        self.__asyncio_loop: asyncio.AbstractEventLoop | None = None
        self.__logger: Logger | None = None
        self.hears_timers = False
        """Whether the handler for timers that fire is registered."""
        self.starts_are_abandoned = False
        """Set after an exception: processes that are scheduled but have not been started must not start."""

    argv: ReadOnly[list[str]] = ReadOnly('The command line arguments.')

    noninteractive: ReadOnly[bool] = ReadOnly('Whether no terminal is attached.')

    is_shutdown: ReadOnly[bool] = ReadOnly('Whether the launch is ending and starts nothing new.')

    def _set_is_shutdown(self, state: bool) -> None:
        self.__is_shutdown = state

    asyncio_loop: ReadOnly[Any] = ReadOnly('The loop that runs launch; None while launch is not running.')

    def _set_asyncio_loop(self, loop: asyncio.AbstractEventLoop | None) -> None:
        self.__asyncio_loop = loop

    # -- values

    launch_configurations: ReadOnly[dict[str, Any]] = ReadOnly('The current launch configurations, by name.')

    def _push_launch_configurations(self) -> None:
        self.__launch_configurations_stack.append(dict(self.__launch_configurations))

    def _pop_launch_configurations(self) -> None:
        if not self.__launch_configurations_stack:
            raise RuntimeError('launch_configurations stack unexpectedly empty')
        self.__launch_configurations = self.__launch_configurations_stack.pop()

    environment: ReadOnly[MutableMapping[str, str]] = ReadOnly("The current environment variables of launch's process.")

    def _push_environment(self) -> None:
        self.__environment_stack.append(dict(self.__environment))

    def _pop_environment(self) -> None:
        if not self.__environment_stack:
            raise RuntimeError('environment stack unexpectedly empty')
        self.__set_environment(self.__environment_stack.pop())

    def _reset_environment(self) -> None:
        self.__set_environment(self.__environment_at_start)

    def __set_environment(self, wanted: dict[str, str]) -> None:
        if self.__environment != wanted:
            self.__environment.clear()
            self.__environment.update(wanted)

    @property
    def locals(self) -> LocalsView:
        """The locals, and the globals that no local overrides, as read-only attributes."""
        return LocalsView(self.get_locals_as_dict())

    def get_locals_as_dict(self) -> dict[str, Any]:
        """Return the globals, overridden by the locals."""
        return {**self.__globals, **self.__locals}

    def local(self, name: str) -> Any:
        """Return the value of one local or global, or None for an unknown name."""
        return self.__locals[name] if name in self.__locals else self.__globals.get(name)

    def extend_globals(self, extensions: dict[str, Any]) -> None:
        """Add globals. Popping locals does not remove them."""
        self.__globals.update(extensions)

    def extend_locals(self, extensions: dict[str, Any]) -> None:
        """Add locals. They are removed when the running event handler ends."""
        self.__locals.update(extensions)

    def _push_locals(self) -> None:
        self.__locals_stack.append(dict(self.__locals))

    def _pop_locals(self) -> None:
        if not self.__locals_stack:
            raise RuntimeError('locals stack unexpectedly empty')
        self.__locals = self.__locals_stack.pop()

    def perform_substitution(self, sub: Performed) -> str:
        """Evaluate a substitution in this context."""
        return sub.perform(self)

    # -- events

    @property
    def _event_queue(self) -> EventQueue:
        if self.__event_queue is None:
            from ._event_queue import EventQueue

            self.__event_queue = EventQueue()
        return self.__event_queue

    @property
    def _event_handlers(self) -> deque[Handler]:
        return self.__handlers.as_deque()

    @property
    def _completion_futures(self) -> list[asyncio.Future[Any]]:
        return self.__completion_futures

    def add_completion_future(self, completion_future: asyncio.Future[Any]) -> None:
        """Keep launch from being idle before this future is done."""
        self.__completion_futures.append(completion_future)

    def register_event_handler(self, event_handler: Handler, append: bool = False) -> None:
        """Register a handler for later events: after all other handlers with `append`, and otherwise before them."""
        self.__handlers.add(event_handler, append=append)
        if self.observer is not None:
            self.observer.registered(event_handler)

    def unregister_event_handler(self, event_handler: Handler) -> None:
        """Unregister a handler.

        :raises ValueError: when the handler is not registered.
        """
        self.__handlers.remove(event_handler)
        if self.observer is not None:
            self.observer.unregistered(event_handler)

    def handlers_that_match(self, event: Event) -> list[Handler]:
        """Return the registered handlers that could match the event, in the order in which they are tried."""
        return self.__handlers.candidates(event)

    def would_handle_event(self, event: Event) -> bool:
        """Return whether any registered handler matches the event."""
        return self.__handlers.matches(event)

    def emit_event_sync(self, event: Event) -> None:
        """Append an event to the queue."""
        self.__log_emission('synchronously', event)
        self._event_queue.put_nowait(event)

    async def emit_event(self, event: Event) -> None:
        """Append an event to the queue."""
        self.__log_emission('asynchronously', event)
        await self._event_queue.put(event)

    def __log_emission(self, how: str, event: Event) -> None:
        if self.__logger is None:
            from .logging import get_logger

            self.__logger = get_logger(__name__)
        if self.__logger.isEnabledFor(10):
            self.__logger.debug(f"emitting event {how}: '{event.name}'")
