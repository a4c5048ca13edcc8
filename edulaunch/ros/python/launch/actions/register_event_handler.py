"""The action `RegisterEventHandler`."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from .._bases import ReadOnly
from ..action import Action
from ..event_handler import BaseEventHandler
from ..launch_description_entity import ConditionalEntities

if TYPE_CHECKING:
    from ..launch_context import LaunchContext


class RegisterEventHandler(Action):
    """Register an event handler. It handles events that happen after the registration."""

    def __init__(self, event_handler: BaseEventHandler, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        self.__event_handler = event_handler

    event_handler: ReadOnly[BaseEventHandler] = ReadOnly('The handler.')

    def execute(self, context: LaunchContext) -> None:
        """Register the handler."""
        context.register_event_handler(self.__event_handler)

    def describe_conditional_sub_entities(self) -> ConditionalEntities:
        """Return the entities of the handler."""
        description = self.__event_handler.describe()
        return [(description[0], description[1])] if description[1] else []  # type: ignore[list-item]
