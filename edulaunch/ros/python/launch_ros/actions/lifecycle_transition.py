"""The action `LifecycleTransition`, which changes the states of lifecycle nodes in several steps."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import suppress
from typing import TYPE_CHECKING, Any

from launch.action import Action
from launch.actions.emit_event import EmitEvent
from launch.actions.opaque_function import OpaqueFunction
from launch.actions.register_event_handler import RegisterEventHandler
from launch.event_handler import EventHandler
from launch.logging import get_logger
from launch.substitution import SomeSubstitutionsType
from launch.utilities.texts import normalize_to_list_of_substitutions, perform_substitutions

from ..events.lifecycle.change_state import ChangeState
from ..events.lifecycle.state_transition import StateTransition
from ..events.matchers import matches_node_name

if TYPE_CHECKING:
    from launch.launch_context import LaunchContext

_STEPS = {
    1: ('configuring', 'inactive'),
    2: ('cleaningup', 'unconfigured'),
    3: ('activating', 'active'),
    4: ('deactivating', 'inactive'),
    **dict.fromkeys((5, 6, 7), ('shuttingdown', 'finalized')),
}
"""The state during a transition, and the state after its success."""


class LifecycleTransition(Action):
    """Trigger transitions of the nodes in order. Each transition is requested after the previous transition has succeeded. An
    error ends the transitions of that node.

    :param lifecycle_node_names: the full names of the nodes.
    :param transition_ids: constants of lifecycle_msgs.msg.Transition, as numbers or strings.
    :raises ValueError: when either list is empty.
    """

    def __init__(self, *, lifecycle_node_names: list[SomeSubstitutionsType], transition_ids: list[Any], **kwargs: Any) -> None:
        super().__init__(**kwargs)
        if not lifecycle_node_names:
            raise ValueError('No lifecycle_node_names provided.')
        if not transition_ids:
            raise ValueError('No transition_ids provided.')
        self.__lifecycle_node_names = [normalize_to_list_of_substitutions(name) for name in lifecycle_node_names]
        self.__transition_ids = [
            normalize_to_list_of_substitutions(str(number) if isinstance(number, int) else number) for number in transition_ids
        ]

    def execute(self, context: LaunchContext) -> list[Action]:
        """Return the handlers that request each later transition, and the events that request the first transitions.

        :raises ValueError: for a transition that is not a number.
        """
        numbers = [_number(perform_substitutions(context, number)) for number in self.__transition_ids]
        names = [perform_substitutions(context, name) for name in self.__lifecycle_node_names]
        sequences = [_Sequence(name, numbers) for name in names]
        for sequence in sequences:
            context.register_event_handler(sequence.on_error)
        return [
            *(RegisterEventHandler(sequence.handlers[step]) for step in range(len(numbers)) for sequence in sequences),
            *(sequence.asking[0] for sequence in sequences),
        ]


def _number(text: str) -> int:
    try:
        return int(text)
    except ValueError:
        raise ValueError(f'expected integer for lifecycle transition, got {text}') from None


class _Sequence:
    """The transitions of one node.

    :ivar asking: the actions that request the transitions.
    :ivar handlers: the handler for the success of each transition, which requests the next one.
    :ivar on_error: the handler that unregisters the others when the node processes an error.
    """

    def __init__(self, name: str, numbers: list[int]) -> None:
        from ..event_handlers.on_state_transition import OnStateTransition

        self.name = name
        self._is_of_node = matches_node_name(name)
        self.asking = [
            EmitEvent(event=ChangeState(lifecycle_node_matcher=self._is_of_node, transition_id=number)) for number in numbers
        ]
        nexts: list[Action] = [*self.asking[1:], OpaqueFunction(function=self._forget)]
        self.handlers = [
            OnStateTransition(matcher=self._reached(*_STEPS[number]), entities=[then], handle_once=True)
            for number, then in zip(numbers, nexts, strict=True)
        ]
        self.on_error = EventHandler(
            matcher=self._reached(None, 'errorprocessing'), entities=[OpaqueFunction(function=self._give_up)], handle_once=True
        )

    def _reached(self, start: str | None, goal: str) -> Callable[[Any], bool]:
        def matcher(event: Any) -> bool:
            return (
                isinstance(event, StateTransition)
                and self._is_of_node(event.action)
                and event.goal_state == goal
                and start in (None, event.start_state)
            )

        return matcher

    def _forget(self, context: LaunchContext) -> None:
        for handler in (*self.handlers, self.on_error):
            with suppress(ValueError):  # the handler has already been removed
                context.unregister_event_handler(handler)

    def _give_up(self, context: LaunchContext) -> None:
        get_logger(__name__).info(f"Stopping transitions for {self.name} because 'error occured during transitions'")
        self._forget(context)
