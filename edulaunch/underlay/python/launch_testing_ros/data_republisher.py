"""Passing on messages, changed."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from rclpy.node import Node


class DataRepublisher:
    """Publishes on one topic what a function makes of the messages of another.

    :param msg_type: class of the messages of both topics.
    :param transform_fn: gives the message to publish, or None for none.
    """

    def __init__(
        self, node: Node, listen_topic: str, publish_topic: str, msg_type: Any, transform_fn: Callable[[Any], Any]
    ) -> None:
        self._node = node
        self._transform_fn = transform_fn
        self._received = 0
        self._republished: list[Any] = []
        self._publisher: Any = node.create_publisher(msg_type, publish_topic, 10)
        self._subscription: Any = node.create_subscription(msg_type, listen_topic, self._on_message, 10)

    def shutdown(self) -> None:
        """Stop listening and publishing."""
        self._node.destroy_subscription(self._subscription)
        self._node.destroy_publisher(self._publisher)

    def get_num_received(self) -> int:
        """How many messages have come."""
        return self._received

    def get_num_republished(self) -> int:
        """How many messages have been published."""
        return len(self._republished)

    def get_republished(self) -> list[Any]:
        """The messages that have been published, oldest first."""
        return list(self._republished)

    def _on_message(self, message: Any) -> None:
        self._received += 1
        changed = self._transform_fn(message)
        if changed is not None:
            self._republished.append(changed)
            self._publisher.publish(changed)
