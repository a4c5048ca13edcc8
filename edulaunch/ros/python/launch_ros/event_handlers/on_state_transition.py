"""The event handler `OnStateTransition`."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from launch.event_handler import EventHandler
from launch.launch_description_entity import SomeEntitiesType
from launch.substitution import SomeSubstitutionsType
from launch.utilities.texts import normalize_to_list_of_substitutions, perform_substitutions

from ..events.lifecycle.state_transition import StateTransition

if TYPE_CHECKING:
    from launch.event import Event

    from ..actions.lifecycle_node import LifecycleNode


class OnStateTransition(EventHandler):
    """Visit entities when a lifecycle node makes a transition.

    :param target_lifecycle_node: the only node whose transitions match; None means any node.
    :param transition: the label of the transition, such as 'configure'; None means any label.
    :param start_state: the label of the previous state, such as 'inactive'; None means any label.
    :param goal_state: the label of the new state; None means any label.
    :param matcher: a matcher in place of all other parameters.
    :raises RuntimeError: when the target is not a LifecycleNode, or `matcher` is combined with other parameters.
    """

    def __init__(
        self,
        *,
        entities: SomeEntitiesType,
        target_lifecycle_node: LifecycleNode | None = None,
        transition: SomeSubstitutionsType | None = None,
        start_state: SomeSubstitutionsType | None = None,
        goal_state: SomeSubstitutionsType | None = None,
        matcher: Callable[[Event], bool] | None = None,
        **kwargs: Any,
    ) -> None:
        if target_lifecycle_node is not None and not _is_lifecycle_node(target_lifecycle_node):
            raise RuntimeError("OnStateTransition requires a 'LifecycleNode' action as the target")
        narrowed = any(one is not None for one in (target_lifecycle_node, transition, start_state, goal_state))
        if matcher is not None and narrowed:
            raise RuntimeError("the 'matcher' argument cannot be used together with a target node, transition or state")
        super().__init__(matcher=matcher or self.__matches, entities=entities, **kwargs)
        self.__target = target_lifecycle_node
        self.__labels = {
            name: _label(value)
            for name, value in (('transition', transition), ('start_state', start_state), ('goal_state', goal_state))
            if value is not None
        }

    def __matches(self, event: Event) -> bool:
        return (
            isinstance(event, StateTransition)
            and (self.__target is None or event.action is self.__target)
            and all(getattr(event, name) == label for name, label in self.__labels.items())
        )

    @property
    def matcher_description(self) -> str:
        """A description of the events that the handler handles."""
        return 'event == StateTransition'


def _is_lifecycle_node(target: Any) -> bool:
    from ..actions.lifecycle_node import LifecycleNode

    return isinstance(target, LifecycleNode)


def _label(value: SomeSubstitutionsType) -> str:
    """Return a label, which must be a plain string because it is needed before a context exists."""
    from launch.launch_context import LaunchContext

    return perform_substitutions(LaunchContext(), normalize_to_list_of_substitutions(value))
