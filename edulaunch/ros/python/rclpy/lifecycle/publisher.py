"""A publisher that sends messages only while its node is active."""

from __future__ import annotations

from typing import Any

from edulaunch.ros.passed_on import passed_on
from rclpy.lifecycle.managed_entity import SimpleManagedEntity
from rclpy.publisher import Publisher


class LifecyclePublisher(SimpleManagedEntity, Publisher):
    """A publisher of a lifecycle node. It drops messages that are published while the node is not active."""

    def __init__(self, *args: Any, **kwargs: Any) -> None:
        SimpleManagedEntity.__init__(self)
        Publisher.__init__(self, *args, **kwargs)

    @SimpleManagedEntity.when_enabled
    def publish(self, msg: Any) -> None:
        """Send a message if the node is active; otherwise drop it."""
        Publisher.publish(self, msg)


__getattr__ = passed_on(__name__)
