"""Actions that let events happen, and that say who reacts to them."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from .._bases import ReadOnly
from .._lazy import has_ros_paths
from ..action import Action
from ..event_handler import BaseEventHandler
from ..events import Event
from ..events import Shutdown as ShutdownEvent
from ..events.process import ProcessExited
from ..launch_description_entity import ConditionalEntities
from ..substitution import SomeSubstitutionsType
from ..utilities.texts import normalize_to_list_of_substitutions, perform_substitutions, plain_text
from ..utilities.type_utils import is_a_subclass

if TYPE_CHECKING:
    from ..launch_context import LaunchContext


class EmitEvent(Action):
    """Emit an event, for handlers to react to.

    :raises RuntimeError: when `event` is no event.
    """

    def __init__(self, *, event: Event, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        if not is_a_subclass(event, Event):
            raise RuntimeError(f"EmitEvent() expected an event instance, got '{event}'.")
        self.__event = event

    event: ReadOnly[Event] = ReadOnly('The event.')

    def execute(self, context: LaunchContext) -> None:
        """Emit it."""
        context.emit_event_sync(self.__event)


class RegisterEventHandler(Action):
    """Register an event handler. It sees events that happen later."""

    def __init__(self, event_handler: BaseEventHandler, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        self.__event_handler = event_handler

    event_handler: ReadOnly[BaseEventHandler] = ReadOnly('The handler.')

    def execute(self, context: LaunchContext) -> None:
        """Register it."""
        context.register_event_handler(self.__event_handler)

    def describe_conditional_sub_entities(self) -> ConditionalEntities:
        """The entities of the handler."""
        description = self.__event_handler.describe()
        return [(description[0], description[1])] if description[1] else []  # type: ignore[list-item]


class UnregisterEventHandler(Action):
    """Forget an event handler.

    :raises ValueError: when executed while the handler is not registered.
    """

    def __init__(self, event_handler: BaseEventHandler, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        self.__event_handler = event_handler

    event_handler: ReadOnly[BaseEventHandler] = ReadOnly('The handler.')

    def execute(self, context: LaunchContext) -> None:
        """Forget it."""
        context.unregister_event_handler(self.__event_handler)


class Shutdown(EmitEvent):
    """End the whole launch. As `on_exit=Shutdown()` of a process: end it when that process ends.

    :param reason: for people; a text or substitutions.
    """

    def __init__(self, *, reason: SomeSubstitutionsType = 'reason not given', **kwargs: Any) -> None:
        text = plain_text(reason)
        super().__init__(event=ShutdownEvent() if text is None else ShutdownEvent(reason=text), **kwargs)
        self.__reason = normalize_to_list_of_substitutions(reason)

    def execute(self, context: LaunchContext) -> None:
        """Emit the shutdown event."""
        event = context.get_locals_as_dict().get('event')
        if isinstance(event, ProcessExited):
            from ..logging import get_logger

            get_logger('launch').info(f'process[{event.process_name}] was required: shutting down launched system')
        context.emit_event_sync(ShutdownEvent(reason=perform_substitutions(context, self.__reason)))


has_ros_paths(__name__)
