"""Managed nodes."""

from __future__ import annotations

from typing import Any

from edulaunch.ros.passed_on import passed_on
from rclpy.callback_groups import CallbackGroup
from rclpy.lifecycle.managed_entity import ManagedEntity
from rclpy.lifecycle.publisher import LifecyclePublisher
from rclpy.lifecycle.state_machine import Life, LifecycleServices, LifecycleState, StateMachineView, TransitionCallbackReturn
from rclpy.node import Node
from rclpy.node_parts.core import NodeCore
from rclpy.qos import QoSProfile


def _life(core: NodeCore) -> Life:
    life: Life = core.life
    return life


class LifecycleNodeMixin(ManagedEntity):
    """Adds a managed lifecycle to a `Node`, for classes that inherit from both classes. Call `Node.__init__` first.

    :param enable_communication_interface: whether to offer the services `~/change_state`, `~/get_state` ... and the topic
        `~/transition_event`.
    :param callback_group: the callback group of those services.
    """

    _rclpy: NodeCore
    create_publisher: Any
    destroy_publisher: Any

    def __init__(self, *, enable_communication_interface: bool = True, callback_group: CallbackGroup | None = None) -> None:
        node: Any = self
        life = self._rclpy.life = Life(node)
        if enable_communication_interface:
            life.services = LifecycleServices(node, life, callback_group)

    def __getattr__(self, name: str) -> Any:
        if name == '_state_machine':
            return StateMachineView(_life(self._rclpy))
        return super().__getattr__(name)  # type: ignore[misc]  # that of Node

    def create_lifecycle_publisher(
        self, msg_type: Any, topic: str, qos_profile: QoSProfile | int, *, publisher_class: None = None, **kwargs: Any
    ) -> LifecyclePublisher:
        """Create a publisher that sends nothing while the node is inactive. The arguments are those of `create_publisher`."""
        if publisher_class is not None:
            raise TypeError("create_publisher() got an unexpected keyword argument 'publisher_class'")
        publisher = self.create_publisher(msg_type, topic, qos_profile, publisher_class=LifecyclePublisher, **kwargs)
        assert isinstance(publisher, LifecyclePublisher)
        self.add_managed_entity(publisher)
        return publisher

    def destroy_lifecycle_publisher(self, publisher: LifecyclePublisher) -> bool:
        """Destroy a lifecycle publisher. Return whether it belonged to this node."""
        entities = _life(self._rclpy).entities
        if publisher in entities:
            entities.remove(publisher)
        return bool(self.destroy_publisher(publisher))

    def add_managed_entity(self, entity: ManagedEntity) -> None:
        """Make an entity follow the node's lifecycle. Raise TypeError for an object that is not a managed entity."""
        if not isinstance(entity, ManagedEntity):
            raise TypeError('Expected a rclpy.lifecycle.ManagedEntity instance.')
        _life(self._rclpy).entities.append(entity)

    def on_configure(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Configure the managed entities, and return the result."""
        return _life(self._rclpy).tell_entities('on_configure', state)

    def on_cleanup(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Clean up the managed entities, and return the result."""
        return _life(self._rclpy).tell_entities('on_cleanup', state)

    def on_shutdown(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Shut down the managed entities, and return the result."""
        return _life(self._rclpy).tell_entities('on_shutdown', state)

    def on_activate(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Activate the managed entities, and return the result."""
        return _life(self._rclpy).tell_entities('on_activate', state)

    def on_deactivate(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Deactivate the managed entities, and return the result."""
        return _life(self._rclpy).tell_entities('on_deactivate', state)

    def on_error(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Report a failed transition to the managed entities, and return the result."""
        return _life(self._rclpy).tell_entities('on_error', state)

    def trigger_configure(self) -> TransitionCallbackReturn:
        """Configure the node. Raise RCLError in a state that does not allow this transition."""
        return _life(self._rclpy).trigger(1)

    def trigger_cleanup(self) -> TransitionCallbackReturn:
        """Clean up the node. Raise RCLError in a state that does not allow this transition."""
        return _life(self._rclpy).trigger(2)

    def trigger_shutdown(self) -> TransitionCallbackReturn:
        """Shut down the node. Raise RCLError in a state that does not allow this transition."""
        return _life(self._rclpy).trigger_shutdown()

    def trigger_activate(self) -> TransitionCallbackReturn:
        """Activate the node. Raise RCLError in a state that does not allow this transition."""
        return _life(self._rclpy).trigger(3)

    def trigger_deactivate(self) -> TransitionCallbackReturn:
        """Deactivate the node. Raise RCLError in a state that does not allow this transition."""
        return _life(self._rclpy).trigger(4)


class LifecycleNode(LifecycleNodeMixin, Node):
    """A node with a managed lifecycle: other nodes can configure, activate, deactivate, clean up and shut down the node.

    Override `on_configure(state)` and similar methods, and call `super().on_activate(state)` to activate managed publishers.

    :param enable_communication_interface: see `LifecycleNodeMixin`. All other arguments are those of `Node`.
    """

    def __init__(self, node_name: str, *, enable_communication_interface: bool = True, **kwargs: Any) -> None:
        Node.__init__(self, node_name, **kwargs)
        LifecycleNodeMixin.__init__(self, enable_communication_interface=enable_communication_interface)


__getattr__ = passed_on(__name__)
