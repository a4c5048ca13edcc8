"""The base class of handlers for events of an action."""

from __future__ import annotations

import collections.abc
from collections.abc import Callable
from typing import TYPE_CHECKING, Any, TypeAlias

from ..event import Event
from ..event_handler import BaseEventHandler
from ..launch_description_entity import LaunchDescriptionEntity, SomeEntitiesType

if TYPE_CHECKING:
    from ..action import Action
    from ..launch_context import LaunchContext

    Reaction = SomeEntitiesType | Callable[..., SomeEntitiesType | None]
    ActionMatcher: TypeAlias = Callable[[Any], bool] | Action | None


class OnActionEventBase(BaseEventHandler):
    """The base class of handlers for events that have an `action`.

    :param action_matcher: an action (exactly that object), a callable that receives the action, or None for every action.
    :param on_event: one or more entities, or a callable that receives the event and the context and may return entities.
    :param target_event_cls: the type of the events to handle.
    :param target_action_cls: the type that the action must have.
    :raises TypeError: for an `action_matcher` or an item of `on_event` of another type.
    """

    def __init__(
        self, *, action_matcher: ActionMatcher, on_event: Reaction, target_event_cls: type, target_action_cls: type, **kwargs: Any
    ) -> None:
        if not (action_matcher is None or callable(action_matcher) or isinstance(action_matcher, target_action_cls)):
            raise TypeError(f"action_matcher must be an '{target_action_cls.__name__}' instance or a callable")
        self.__target_action_cls = target_action_cls
        self.__target_event_cls = target_event_cls
        self.__action_matcher = action_matcher
        super().__init__(matcher=self.__accepts, **kwargs)
        self.only_action = action_matcher if isinstance(action_matcher, LaunchDescriptionEntity) else None
        self.__actions_on_event: list[LaunchDescriptionEntity] = []
        self.__on_event: Any = None
        if callable(on_event):
            self.__on_event = on_event
        elif isinstance(on_event, collections.abc.Iterable):
            self.__actions_on_event = _checked(on_event)
        else:
            self.__actions_on_event = [on_event]

    def __accepts(self, event: Event) -> bool:
        if not isinstance(event, self.__target_event_cls):
            return False
        matcher: Any = self.__action_matcher
        action = event.action  # type: ignore[attr-defined]
        if matcher is None or action is matcher:
            return True
        return not isinstance(matcher, LaunchDescriptionEntity) and bool(matcher(action))

    def handle(self, event: Event, context: LaunchContext) -> SomeEntitiesType | None:
        """Return the entities, or the result of the callable."""
        super().handle(event, context)
        if self.__on_event is not None:
            answer: SomeEntitiesType | None = self.__on_event(event, context)
            return answer
        return self.__actions_on_event

    @property
    def handler_description(self) -> str:
        """The string `<actions>`, or a description of the callable."""
        return '<actions>' if self.__on_event is None else str(self.__on_event)

    @property
    def matcher_description(self) -> str:
        """A description of the events that the handler handles."""
        event = self.__target_event_cls.__name__
        if self.__action_matcher is None:
            return f'event == {event}'
        return f'event == {event} and {self.__target_action_cls.__name__}(event.action)'

    def describe(self) -> tuple[str, list[SomeEntitiesType]]:
        """Return a description of the handler, and the entities that it visits."""
        text = super().describe()[0]
        return text, list(self.__actions_on_event)


def _checked(entities: Any) -> list[LaunchDescriptionEntity]:
    listed = list(entities)
    for entity in listed:
        if not isinstance(entity, LaunchDescriptionEntity):
            raise TypeError(
                f"expected all items in 'on_event' iterable to be of type 'LaunchDescriptionEntity' but got '{type(entity)}'"
            )
    return listed
