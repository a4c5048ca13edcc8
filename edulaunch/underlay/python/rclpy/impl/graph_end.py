"""What publishers, subscriptions, clients and services share: each stands for an endpoint of the graph."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from rclpy.impl.handle import Handle, check_alive

if TYPE_CHECKING:
    from rclpy.clock import Clock
    from rclpy.qos import QoSProfile
    from rclpy.service_introspection import ServiceIntrospectionState


class GraphEnd:
    """Has an endpoint in the graph, given by :meth:`connect`."""

    _impl: Any

    def connect(self, impl: Any) -> None:
        """Stand for this endpoint of the graph."""
        self._impl = impl

    @property
    def logger_name(self) -> str:
        """The name of its node's logger. Raises InvalidHandle when destroyed."""
        check_alive(self._impl)
        name: str = self._impl.node.logger_name
        return name

    @property
    def handle(self) -> Handle:
        """What holds the endpoint in the graph."""
        impl = self._impl
        return Handle(impl, lambda: impl.destroyed)


class TopicEnd(GraphEnd):
    """A publisher or a subscription."""

    @property
    def topic_name(self) -> str:
        """The topic's absolute name, after remapping. Raises InvalidHandle when destroyed."""
        check_alive(self._impl)
        name: str = self._impl.topic_name
        return name


class ServiceEnd(GraphEnd):
    """A client or a service."""

    _introspection: Any = None

    @property
    def service_name(self) -> str:
        """The service's absolute name, after remapping. Raises InvalidHandle when destroyed."""
        check_alive(self._impl)
        name: str = self._impl.service_name
        return name

    def configure_introspection(
        self, clock: Clock, service_event_qos_profile: QoSProfile, introspection_state: ServiceIntrospectionState
    ) -> None:
        """Publish what it sends and receives on `<service>/_service_event`."""
        from rclpy.service_introspection import Introspection

        self._introspection = Introspection.configured(self, clock, service_event_qos_profile, introspection_state)
