"""The action `TimerAction`."""

from __future__ import annotations

import collections.abc
import warnings
from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

from .._bases import ReadOnly
from ..action import Action
from ..event_handler import EventHandler
from ..event_handlers.on_shutdown import OnShutdown
from ..events.timer_event import TimerEvent
from ..launch_description_entity import ConditionalEntities, LaunchDescriptionEntity
from ..substitution import SomeSubstitutionsType, SomeSubstitutionsType_types_tuple
from ..utilities.type_utils import ensure_argument_type, normalize_typed_substitution, perform_typed_substitution
from .opaque_function import OpaqueFunction

if TYPE_CHECKING:
    import asyncio

    from ..launch_context import LaunchContext


class TimerAction(Action):
    """Visit actions once, after `period` seconds of simulated time, unless the timer is cancelled first.

    The actions see the locals from the time when the timer was executed, but the launch configurations from the time when the
    timer fires. By then, the configurations of an enclosing group no longer exist.

    :param period: the seconds to wait; a float (not an int), or substitutions.
    :param actions: the actions to visit when the timer fires.
    :param cancel_on_shutdown: whether a shutdown cancels the timer; a boolean or substitutions.
    :raises TypeError: when an argument has the wrong type.
    """

    def __init__(
        self,
        *,
        period: float | SomeSubstitutionsType,
        actions: Iterable[LaunchDescriptionEntity],
        cancel_on_shutdown: bool | SomeSubstitutionsType = True,
        **kwargs: Any,
    ) -> None:
        super().__init__(**kwargs)
        ensure_argument_type(period, (*SomeSubstitutionsType_types_tuple, float), 'period', 'TimerAction')
        ensure_argument_type(actions, collections.abc.Iterable, 'actions', 'TimerAction')
        if isinstance(period, str):
            warnings.warn(
                "The parameter 'period' must be a float or substitution, passing a string literal is deprecated", stacklevel=2
            )
            period = float(period)
        self.__period = normalize_typed_substitution(period, float)
        self.__actions = actions
        self.__cancel_on_shutdown = normalize_typed_substitution(cancel_on_shutdown, bool)
        self.__context_locals: dict[str, Any] = {}
        self.__canceled = False
        self._completed_future: asyncio.Future[Any] | None = None
        self._canceled_future: asyncio.Future[Any] | None = None

    period: ReadOnly[Any] = ReadOnly('The seconds to wait, or substitutions.')
    actions: ReadOnly[Iterable[LaunchDescriptionEntity]] = ReadOnly('The actions to visit when the timer fires.')

    def describe(self) -> str:
        """Return a description such as `TimerAction(period=2.0, actions=<actions>)`."""
        return f'TimerAction(period={self.__period}, actions=<actions>)'

    def describe_conditional_sub_entities(self) -> ConditionalEntities:
        """Return the actions."""
        return [(f'{self.__period} seconds pass without being canceled', self.__actions)]

    def handle(self, context: LaunchContext) -> Iterable[LaunchDescriptionEntity]:
        """Return the actions to visit when the timer fires."""
        context.extend_locals(self.__context_locals)
        return self.__actions

    def cancel(self) -> None:
        """Cancel the timer, so that its actions are not visited. After the timer has fired, this call has no effect."""
        self.__canceled = True
        if self._canceled_future is not None and not self._canceled_future.done():
            self._canceled_future.set_result(True)

    async def _wait_to_fire_event(self, context: LaunchContext) -> None:
        import asyncio

        assert self._canceled_future is not None and self._completed_future is not None
        try:
            period = perform_typed_substitution(context, self.__period, float)
            await asyncio.wait([self._canceled_future], timeout=period)  # type: ignore[arg-type]
            if not self._canceled_future.done():
                await context.emit_event(TimerEvent(timer_action=self))
        except Exception as error:
            self._completed_future.set_exception(error)
        else:
            self._completed_future.set_result(None)

    def execute(self, context: LaunchContext) -> None:
        """Start the timer."""
        loop = context.asyncio_loop
        self._completed_future = loop.create_future()
        self._canceled_future = loop.create_future()
        if self.__canceled:
            self._completed_future.set_result(None)
            return
        if not context.hears_timers:
            context.register_event_handler(_TimerEventHandler())
            context.hears_timers = True
        self.__context_locals = context.get_locals_as_dict()
        loop.create_task(self._wait_to_fire_event(context))
        if perform_typed_substitution(context, self.__cancel_on_shutdown, bool):
            context.register_event_handler(OnShutdown(on_shutdown=lambda event, context: self.cancel()))

    def get_asyncio_future(self) -> asyncio.Future[Any] | None:
        """Return a future that is done when the timer has fired or was cancelled."""
        return self._completed_future


class _TimerEventHandler(EventHandler):
    """Handles the events of all timers of a context."""

    def __init__(self) -> None:
        super().__init__(
            matcher=lambda event: isinstance(event, TimerEvent), entities=OpaqueFunction(function=_handle_timer_event)
        )


def _handle_timer_event(context: LaunchContext) -> Iterable[LaunchDescriptionEntity]:
    event: TimerEvent = context.locals.event
    return event.timer_action.handle(context)
