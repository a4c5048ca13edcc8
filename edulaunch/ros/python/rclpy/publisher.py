"""Publishers of topics."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from edulaunch.engine.facts import kind_of, with_facts
from edulaunch.engine.sim.task import current_task
from edulaunch.ros.passed_on import passed_on
from rclpy.duration import Duration
from rclpy.impl.entity import TopicEnd, check_endpoint
from rclpy.impl.refusals import after_shutdown, invalid_handle

if TYPE_CHECKING:
    from edulaunch.engine.graph.topics import Publisher as GraphPublisher
    from rclpy.context import Context
    from rclpy.qos import QoSProfile

FOR_EVER = Duration(seconds=-1)


class Publisher(TopicEnd):
    """A publisher of a topic, created by `Node.create_publisher`. Messages are copied when they are published."""

    endpoint: GraphPublisher

    def __init__(
        self, publisher_impl: GraphPublisher, msg_type: Any, topic: str, qos_profile: QoSProfile, context: Context
    ) -> None:
        self.msg_type = msg_type
        self.topic = topic
        self.qos_profile = qos_profile
        self.event_handlers: list[Any] = []
        self.endpoint = publisher_impl
        self.context = context
        self._to_wire = msg_type.to_wire
        keep_up = current_task().sim.keep_up
        self.send_wire: Callable[[Any], object] = publisher_impl.publish
        if keep_up is not None:

            def send_at_present_time(wire: Any) -> None:
                keep_up()
                publisher_impl.publish(wire)

            self.send_wire = send_at_present_time

    def publish(self, msg: Any) -> None:
        """Send a message, or the bytes of a serialized message, to all current subscriptions.

        :raises TypeError: for a message of another class.
        :raises RCLError: after shutdown.
        """
        if msg.__class__ is self.msg_type and self.context.alive:
            self.send_wire(self._to_wire(msg))
        else:
            self._publish_other(msg)

    def _publish_other(self, msg: Any) -> None:
        if not (isinstance(msg, (self.msg_type, bytes))):
            raise TypeError(f'Expected {self.msg_type}, got {type(msg)}')
        if self.endpoint.destroyed:
            raise invalid_handle()
        if not self.context.alive:
            raise after_shutdown('Failed to publish: publisher')
        if isinstance(msg, bytes):
            from edulaunch.ros.serialization.cdr import decode

            self.send_wire(decode(self.msg_type, msg))
        else:
            self.send_wire(self._to_wire(msg))

    def get_subscription_count(self) -> int:
        """Return the number of subscriptions that receive the messages. Raise InvalidHandle after destroy, and RCLError after
        shutdown.
        """
        check_endpoint(self.endpoint, self.context, 'failed to get subscription count: publisher')
        current_task().poll()
        return self.endpoint.subscription_count

    def assert_liveliness(self) -> None:
        """Assert that the publisher is alive. With the liveliness MANUAL_BY_TOPIC, this is necessary while it publishes nothing.

        :raises RCLError: after shutdown.
        """
        check_endpoint(self.endpoint, self.context, 'Failed to assert liveliness on the Publisher: publisher')
        show_life = getattr(self.endpoint, 'show_life', None)
        if show_life is not None:
            show_life()

    def wait_for_all_acked(self, timeout: Duration = FOR_EVER) -> bool:
        """Return True, because delivery takes no time and all messages have arrived.

        :param timeout: how long to wait; a negative Duration means no limit.
        :raises AttributeError: when `timeout` is not a Duration.
        :raises RCLError: after shutdown.
        """
        check_endpoint(self.endpoint, self.context, 'Failed to wait for all acknowledgements: publisher')
        if not isinstance(timeout, Duration):
            raise with_facts(
                AttributeError(f"'{type(timeout).__name__}' object has no attribute '_duration_handle'"),
                'programs.timeout-no-duration',
                given=kind_of(timeout),
                call='wait_for_all_acked(Duration(seconds=1))',
            )
        return True

    def destroy(self) -> None:
        """Destroy the publisher. Prefer `Node.destroy_publisher`."""
        for handler in self.event_handlers:
            handler.destroy()
        self.endpoint.destroy()
        self.send_wire = self._refuse

    def _refuse(self, _: Any) -> None:
        raise invalid_handle()


__getattr__ = passed_on(__name__)
