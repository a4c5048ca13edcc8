"""Handlers for the events of launch itself and of any action."""

from __future__ import annotations

import collections.abc
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from .._lazy import has_ros_paths
from ..event_handler import BaseEventHandler
from ..events import Event, ExecutionComplete, IncludeLaunchDescription, Shutdown
from ..launch_description_entity import LaunchDescriptionEntity, SomeEntitiesType

if TYPE_CHECKING:
    from ..action import Action
    from ..launch_context import LaunchContext

    ShutdownReaction = SomeEntitiesType | Callable[[Shutdown, LaunchContext], SomeEntitiesType | None]
    Reaction = SomeEntitiesType | Callable[..., SomeEntitiesType | None]
    ActionMatcher = Callable[[Any], bool] | Action | None


def event_named(name: str) -> Callable[[Event], bool]:
    """Accepts events whose `name` is this, such as 'launch.events.Shutdown'."""
    return lambda event: event.name == name


class OnIncludeLaunchDescription(BaseEventHandler):
    """Visits the description of each `IncludeLaunchDescription` event; the launch service has one of these."""

    def __init__(self, **kwargs: Any) -> None:
        super().__init__(matcher=lambda event: isinstance(event, IncludeLaunchDescription), **kwargs)

    def handle(self, event: Event, context: LaunchContext) -> SomeEntitiesType | None:
        """The description."""
        super().handle(event, context)
        assert isinstance(event, IncludeLaunchDescription)
        return event.launch_description

    @property
    def handler_description(self) -> str:
        """What the handler does, in words."""
        return 'returns the launch_description in the event'

    @property
    def matcher_description(self) -> str:
        """Which events are handled, in words."""
        return 'event issubclass of launch.events.IncludeLaunchDescription'


class OnShutdown(BaseEventHandler):
    """Reacts when the launch is asked to end.

    :param on_shutdown: an entity, several, or a callable (event, context) that may return entities.
    """

    def __init__(self, *, on_shutdown: ShutdownReaction, **kwargs: Any) -> None:
        super().__init__(matcher=lambda event: isinstance(event, Shutdown), **kwargs)
        self.__on_shutdown: Any = on_shutdown

    def handle(self, event: Event, context: LaunchContext) -> SomeEntitiesType | None:
        """The entities, or what the callable returns."""
        super().handle(event, context)
        answer: SomeEntitiesType | None = (
            self.__on_shutdown(event, context) if callable(self.__on_shutdown) else self.__on_shutdown
        )
        return answer

    @property
    def handler_description(self) -> str:
        """The callable, or the entities."""
        return str(self.__on_shutdown)

    @property
    def matcher_description(self) -> str:
        """Which events are handled, in words."""
        return 'event issubclass of launch.events.Shutdown'

    def describe(self) -> tuple[str, list[SomeEntitiesType]]:
        """The handler in words, and its entities."""
        text = super().describe()[0]
        if callable(self.__on_shutdown):
            return text, []
        entities = self.__on_shutdown
        return text, list(entities) if hasattr(entities, '__iter__') else [entities]


class OnActionEventBase(BaseEventHandler):
    """Base of the handlers for events that have an `action`.

    :param action_matcher: an action (that very object), a callable that gets the action, or None for every
        action.
    :param on_event: an entity, several, or a callable that gets the event and the context and may return
        entities.
    :param target_event_cls: the type of events.
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
        """The entities, or what the callable returns."""
        super().handle(event, context)
        if self.__on_event is not None:
            answer: SomeEntitiesType | None = self.__on_event(event, context)
            return answer
        return self.__actions_on_event

    @property
    def handler_description(self) -> str:
        """`<actions>`, or the callable."""
        return '<actions>' if self.__on_event is None else str(self.__on_event)

    @property
    def matcher_description(self) -> str:
        """Which events are handled, in words."""
        event = self.__target_event_cls.__name__
        if self.__action_matcher is None:
            return f'event == {event}'
        return f'event == {event} and {self.__target_action_cls.__name__}(event.action)'

    def describe(self) -> tuple[str, list[SomeEntitiesType]]:
        """The handler in words, and its entities."""
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


class OnExecutionComplete(OnActionEventBase):
    """Reacts when an action has been executed (a process: when it has ended; a timer: when it has run out).

    :param target_action: the action, a callable that decides, or None for every action.
    :param on_completion: an entity, several, or a callable (event, context) that may return entities.
    """

    def __init__(self, *, target_action: ActionMatcher = None, on_completion: Reaction, **kwargs: Any) -> None:
        from ..action import Action

        super().__init__(
            action_matcher=target_action,
            on_event=on_completion,
            target_event_cls=ExecutionComplete,
            target_action_cls=Action,
            **kwargs,
        )


has_ros_paths(__name__)
