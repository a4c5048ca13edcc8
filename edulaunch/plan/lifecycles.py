"""Lifecycle nodes in a plan: every transition that they are asked for succeeds, so that what waits for it is planned too."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from launch.launch_context import LaunchContext

FIRST_STATE = 'unconfigured'


class ImaginedLifecycles:
    """The states that the LifecycleNodes of one plan would be in."""

    def __init__(self) -> None:
        self._states: dict[Any, str] = {}

    def change(self, context: LaunchContext, node: Any, transition_id: int) -> bool:
        """Make a transition and tell launch of both its steps, as the node's topic `transition_event` does.

        :param node: the LifecycleNode action.
        :returns: False when the transition does not begin in the node's state.
        """
        from rclpy.lifecycle.state_machine import OUTCOMES, TransitionCallbackReturn, transition_from

        state = self._states.get(node, FIRST_STATE)
        transition = transition_from(state, transition_id)
        if transition is None:
            return False
        outcome = OUTCOMES[transition.during][TransitionCallbackReturn.SUCCESS]
        self._tell(context, node, transition.label, state, transition.during)
        self._tell(context, node, outcome.label, transition.during, outcome.goal)
        self._states[node] = outcome.goal
        return True

    @staticmethod
    def _tell(context: LaunchContext, node: Any, label: str, start: str, goal: str) -> None:
        from launch_ros.events.lifecycle.state_transition import StateTransition
        from lifecycle_msgs.msg import TransitionEvent

        message: Any = TransitionEvent()
        message.transition.label, message.start_state.label, message.goal_state.label = label, start, goal
        context.emit_event_sync(StateTransition(action=node, msg=message))
