"""Moving lifecycle nodes through several states."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from launch.action import Action
from launch.actions.emit_event import EmitEvent
from launch.actions.register_event_handler import RegisterEventHandler
from launch.some_substitutions_type import SomeSubstitutionsType
from launch.utilities.normalize_to_list_of_substitutions_impl import normalize_to_list_of_substitutions
from launch.utilities.perform_substitutions_impl import perform_substitutions

from ..events.lifecycle.change_state import ChangeState
from ..events.matches_node_name import matches_node_name

if TYPE_CHECKING:
    from launch.launch_context import LaunchContext

# After which state a transition has succeeded.
_GOALS = {1: 'inactive', 2: 'unconfigured', 3: 'active', 4: 'inactive', 5: 'finalized', 6: 'finalized', 7: 'finalized'}


class LifecycleTransition(Action):
    """Make each of the nodes go through the transitions in order; the next one is asked for when the one
    before has succeeded.

    :param lifecycle_node_names: full names.
    :param transition_ids: constants of lifecycle_msgs.msg.Transition, as numbers or texts.
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
        """Ask for the first transitions, and register handlers for the rest."""
        from ..event_handlers import OnStateTransition
        from ..events.lifecycle.state_transition import StateTransition

        numbers = [int(perform_substitutions(context, number)) for number in self.__transition_ids]
        actions: list[Action] = []
        for substitutions in self.__lifecycle_node_names:
            matcher = matches_node_name(perform_substitutions(context, substitutions))
            for before, number in zip(numbers, numbers[1:], strict=False):

                def reached(event: Any, goal: str = _GOALS[before], node: Any = matcher) -> bool:
                    return isinstance(event, StateTransition) and node(event.action) and event.goal_state == goal

                actions.append(
                    RegisterEventHandler(
                        OnStateTransition(
                            matcher=reached,
                            handle_once=True,
                            entities=[EmitEvent(event=ChangeState(lifecycle_node_matcher=matcher, transition_id=number))],
                        )
                    )
                )
            actions.append(EmitEvent(event=ChangeState(lifecycle_node_matcher=matcher, transition_id=numbers[0])))
        return actions
