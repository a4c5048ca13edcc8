"""The life of one managed node: where it stands, and how it gets from state to state."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from edulaunch.facts import with_facts
from rclpy._rclpy_pybind11 import RCLError
from rclpy.lifecycle.state_machine import OUTCOMES, STATES, TRANSITIONS, LifecycleState, TransitionCallbackReturn, transition_from
from rclpy.logging import get_logger
from rclpy.node_parts.core import core_of

if TYPE_CHECKING:
    from rclpy.lifecycle.managed_entity import ManagedEntity
    from rclpy.lifecycle.node import LifecycleNode
    from rclpy.lifecycle.services import LifecycleServices

OnTransition = Callable[[LifecycleState], TransitionCallbackReturn]


class Life:
    """Kept with the node's other state, so that a student's own attributes cannot collide with it.

    :ivar entities: what follows the node through its states.
    :ivar callbacks: what was registered in place of the node's methods, by the method's name.
    """

    def __init__(self, node: LifecycleNode) -> None:
        self.node = node
        self.state = STATES['unconfigured']
        self.entities: list[ManagedEntity] = []
        self.callbacks: dict[str, OnTransition] = {}
        self.services: LifecycleServices | None = None

    def tell_entities(self, callback: str, state: LifecycleState) -> TransitionCallbackReturn:
        """Call a method of all entities, until one does not succeed."""
        for entity in self.entities:
            result: TransitionCallbackReturn = getattr(entity, callback)(state)
            if result is not TransitionCallbackReturn.SUCCESS:
                return result
        return TransitionCallbackReturn.SUCCESS

    def trigger(self, wanted: int | str) -> TransitionCallbackReturn:
        """Do a transition, by number or label, with its callback and what follows from that callback's answer.

        :raises RCLError: in a state that does not allow it.
        """
        start = self.state
        transition = transition_from(start.label, wanted)
        if transition is None:
            get_logger('rcl_lifecycle').warning(f'No transition matching {wanted} found for current state {start.label}')
            raise with_facts(
                RCLError('Failed to trigger lifecycle state machine transition: Transition is not registered.'),
                'programs.no-transition',
                node=self.node.get_fully_qualified_name(),
                state=start.label,
                possible=[f'{one.number} ({one.label})' for one in TRANSITIONS if one.start == start.label],
            )
        self._enter(transition.during)
        result = self._call(transition.callback, start)
        self._leave(result)
        if self.state.label == 'errorprocessing':
            self._leave(self._call('on_error', start))
        return result

    def trigger_shutdown(self) -> TransitionCallbackReturn:
        """Do the shutdown of the present state. Raises RCLError in a state that has none."""
        for transition in TRANSITIONS:
            if transition.start == self.state.label and transition.label == 'shutdown':
                return self.trigger(transition.number)
        raise RCLError('Shutdown transtion not possible')  # [sic]: ROS 2's own text

    def _call(self, callback: str, start: LifecycleState) -> TransitionCallbackReturn:
        function = self.callbacks.get(callback) or getattr(self.node, callback)
        try:
            result = function(start)
        except Exception as error:
            return self._mistaken(callback, {'raised': f'{type(error).__name__}: {error}'})
        if not isinstance(result, TransitionCallbackReturn):
            return self._mistaken(callback, {'returned': repr(result)})
        return result

    def _mistaken(self, callback: str, how: dict[str, str]) -> TransitionCallbackReturn:
        """ROS 2 takes it for TransitionCallbackReturn.ERROR and says nothing: a fact."""
        core = core_of(self.node)
        core.process.fact(
            'transition failed', (core.entry.index, callback), {'node': core.full_name, 'callback': callback, **how}
        )
        return TransitionCallbackReturn.ERROR

    def _leave(self, result: TransitionCallbackReturn) -> None:
        self._enter(OUTCOMES[self.state.label][result].goal)

    def _enter(self, goal: str) -> None:
        start, self.state = self.state, STATES[goal]
        if self.services is not None:
            self.services.publish_event(start, self.state)
