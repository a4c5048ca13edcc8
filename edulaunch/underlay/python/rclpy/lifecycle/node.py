"""Managed nodes."""
from __future__ import annotations

from collections.abc import Callable
from typing import Any

from rclpy._rclpy_pybind11 import RCLError
from rclpy.lifecycle.managed_entity import ManagedEntity
from rclpy.lifecycle.publisher import LifecyclePublisher
from rclpy.lifecycle.services import LifecycleServices
from rclpy.lifecycle.state_machine import (
    OUTCOMES,
    STATES,
    LifecycleState,
    TransitionCallbackReturn,
    transition_from,
)
from rclpy.node import Node
from rclpy.qos import QoSProfile

OnTransition = Callable[[LifecycleState], TransitionCallbackReturn]


class LifecycleNode(Node, ManagedEntity):
    """A node that others configure, activate, deactivate, clean up and shut down.

    Override `on_configure(state)` and the like; call `super().on_activate(state)` to activate managed publishers.

    :param enable_communication_interface: whether to offer the services `~/change_state`, `~/get_state` ... and the topic
        `~/transition_event`.
    """

    def __init__(self, node_name: str, *, enable_communication_interface: bool = True, **kwargs: Any) -> None:
        super().__init__(node_name, **kwargs)
        self._lifecycle_state = STATES['unconfigured']
        self._managed_entities: list[ManagedEntity] = []
        self._lifecycle_callbacks: dict[str, OnTransition] = {}
        self._lifecycle_services = LifecycleServices(self) if enable_communication_interface else None

    def create_lifecycle_publisher(self, msg_type: Any, topic: str, qos_profile: QoSProfile | int, *,
                                   publisher_class: None = None, **kwargs: Any) -> LifecyclePublisher:
        """Make a publisher that is silent while the node is not active; arguments as of `create_publisher`."""
        if publisher_class is not None:
            raise TypeError("create_publisher() got an unexpected keyword argument 'publisher_class'")
        publisher = self.create_publisher(msg_type, topic, qos_profile, publisher_class=LifecyclePublisher, **kwargs)
        assert isinstance(publisher, LifecyclePublisher)
        self.add_managed_entity(publisher)
        return publisher

    def destroy_lifecycle_publisher(self, publisher: LifecyclePublisher) -> bool:
        """Destroy such a publisher; whether it was one of this node."""
        if publisher in self._managed_entities:
            self._managed_entities.remove(publisher)
        return self.destroy_publisher(publisher)

    def add_managed_entity(self, entity: ManagedEntity) -> None:
        """Let an entity follow the node's life cycle."""
        self._managed_entities.append(entity)

    def _tell_entities(self, callback: str, state: LifecycleState) -> TransitionCallbackReturn:
        for entity in self._managed_entities:
            result: TransitionCallbackReturn = getattr(entity, callback)(state)
            if result is not TransitionCallbackReturn.SUCCESS:
                return result
        return TransitionCallbackReturn.SUCCESS

    def on_configure(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Configure the managed entities."""
        return self._tell_entities('on_configure', state)

    def on_cleanup(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Clean the managed entities up."""
        return self._tell_entities('on_cleanup', state)

    def on_shutdown(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Shut the managed entities down."""
        return self._tell_entities('on_shutdown', state)

    def on_activate(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Activate the managed entities."""
        return self._tell_entities('on_activate', state)

    def on_deactivate(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Deactivate the managed entities."""
        return self._tell_entities('on_deactivate', state)

    def on_error(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Tell the managed entities that a transition went wrong."""
        return self._tell_entities('on_error', state)

    def register_callback(self, state_id: int, callback: OnTransition) -> bool:
        """Call this in place of the method of a state of passage (10 configuring ... 15 errorprocessing)."""
        names = {10: 'on_configure', 11: 'on_cleanup', 12: 'on_shutdown', 13: 'on_activate', 14: 'on_deactivate', 15: 'on_error'}
        if state_id not in names:
            return False
        self._lifecycle_callbacks[names[state_id]] = callback
        return True

    def trigger_configure(self) -> TransitionCallbackReturn:
        """Configure the node. Raises RCLError in a state that does not allow it."""
        return self._trigger('configure')

    def trigger_cleanup(self) -> TransitionCallbackReturn:
        """Clean the node up. Raises RCLError in a state that does not allow it."""
        return self._trigger('cleanup')

    def trigger_shutdown(self) -> TransitionCallbackReturn:
        """Shut the node down. Raises RCLError in a state that does not allow it."""
        return self._trigger('shutdown')

    def trigger_activate(self) -> TransitionCallbackReturn:
        """Activate the node. Raises RCLError in a state that does not allow it."""
        return self._trigger('activate')

    def trigger_deactivate(self) -> TransitionCallbackReturn:
        """Deactivate the node. Raises RCLError in a state that does not allow it."""
        return self._trigger('deactivate')

    def _trigger(self, wanted: int | str) -> TransitionCallbackReturn:
        """Do a transition, by number or label, with its callback and what follows from that callback's answer."""
        start = self._lifecycle_state
        transition = transition_from(start.label, wanted)
        if transition is None:
            raise RCLError(f"Failed to trigger lifecycle state machine transition: no transition matching '{wanted}' found for "
                           f'current state {start.label}')
        self._enter(transition.number, transition.label, transition.during)
        result = self._call(transition.callback, start)
        self._leave(result)
        if self._lifecycle_state.label == 'errorprocessing':
            self._leave(self._call('on_error', start))
        return result

    def _call(self, callback: str, start: LifecycleState) -> TransitionCallbackReturn:
        function = self._lifecycle_callbacks.get(callback) or getattr(self, callback)
        try:
            result = function(start)
        except Exception as error:
            self.get_logger().error(f'Exception in {callback}: {type(error).__name__}: {error}')
            return TransitionCallbackReturn.ERROR
        return result if isinstance(result, TransitionCallbackReturn) else TransitionCallbackReturn.ERROR

    def _leave(self, result: TransitionCallbackReturn) -> None:
        outcome = OUTCOMES[self._lifecycle_state.label][result]
        self._enter(outcome.number, outcome.label, outcome.goal)

    def _enter(self, number: int, label: str, goal: str) -> None:
        start, self._lifecycle_state = self._lifecycle_state, STATES[goal]
        if self._lifecycle_services is not None:
            self._lifecycle_services.publish_event(number, label, start, self._lifecycle_state)
