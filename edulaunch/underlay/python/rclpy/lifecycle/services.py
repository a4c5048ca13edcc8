"""How others see and steer the life cycle of a managed node."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from rclpy._rclpy_pybind11 import RCLError
from rclpy.lifecycle.state_machine import STATES, LifecycleState, TransitionCallbackReturn, all_transitions

if TYPE_CHECKING:
    from rclpy.callback_groups import CallbackGroup
    from rclpy.lifecycle.life import Life
    from rclpy.lifecycle.node import LifecycleNode


class LifecycleServices:
    """The five services and the topic of a managed node."""

    def __init__(self, node: LifecycleNode, life: Life, group: CallbackGroup | None = None) -> None:
        from lifecycle_msgs import srv
        from lifecycle_msgs.msg import TransitionEvent

        self._life = life
        self._events = node.create_publisher(TransitionEvent, '~/transition_event', 10)
        for kind, name, answer in (
            (srv.ChangeState, 'change_state', self._on_change_state),
            (srv.GetState, 'get_state', self._on_get_state),
            (srv.GetAvailableStates, 'get_available_states', self._on_get_available_states),
            (srv.GetAvailableTransitions, 'get_available_transitions', self._on_get_available_transitions),
            (srv.GetAvailableTransitions, 'get_transition_graph', self._on_get_transition_graph),
        ):
            node.create_service(kind, f'{node.get_fully_qualified_name()}/{name}', answer, callback_group=group)

    def publish_event(self, start: LifecycleState, goal: LifecycleState) -> None:
        """Tell of a step. As in ROS 2 the event names the two states and leaves its time and its transition empty."""
        from lifecycle_msgs.msg import TransitionEvent

        self._events.publish(TransitionEvent(start_state=_state(start), goal_state=_state(goal)))

    def _on_change_state(self, request: Any, response: Any) -> Any:
        """A label that does not suit is refused; a number that does not suit is an error of the node, as in rclpy."""
        label = request.transition.label
        try:
            response.success = self._life.trigger(label or request.transition.id) is TransitionCallbackReturn.SUCCESS
        except RCLError:
            if not label:
                raise
            response.success = False
        return response

    def _on_get_state(self, request: Any, response: Any) -> Any:
        response.current_state = _state(self._life.state)
        return response

    def _on_get_available_states(self, request: Any, response: Any) -> Any:
        response.available_states = [_state(state) for state in STATES.values()]
        return response

    def _on_get_available_transitions(self, request: Any, response: Any) -> Any:
        here = self._life.state.label
        response.available_transitions = [_description(*one) for one in all_transitions() if one[2] == here]
        return response

    def _on_get_transition_graph(self, request: Any, response: Any) -> Any:
        response.available_transitions = [_description(*one) for one in all_transitions()]
        return response


def _state(state: LifecycleState) -> Any:
    from lifecycle_msgs.msg import State

    return State(id=state.state_id, label=state.label)


def _description(number: int, label: str, start: str, goal: str) -> Any:
    from lifecycle_msgs.msg import Transition, TransitionDescription

    return TransitionDescription(
        transition=Transition(id=number, label=label), start_state=_state(STATES[start]), goal_state=_state(STATES[goal])
    )
