"""Waits until topics have messages."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Iterable
from typing import Any

from edulaunch.engine.sim.sync import Event

from .message_pump import MessagePump


class WaitForTopics:
    """Waits for a message on each of several topics: `with WaitForTopics([('chatter', String)]): ...`.

    :param topic_tuples: a list of (topic, message class) or (topic, message class, QoS profile).
    :param timeout: the maximum time to wait in simulated seconds.
    :param messages_received_buffer_length: the number of newest messages of each topic that are stored.
    :param trigger: a function that :meth:`wait` calls as trigger(node, *args, **kwargs) before it waits.
    """

    def __init__(
        self,
        topic_tuples: Iterable[tuple[Any, ...]],
        timeout: float = 5.0,
        messages_received_buffer_length: int = 10,
        trigger: Callable[..., object] | None = None,
    ) -> None:
        import rclpy
        from rclpy.context import Context

        self.topic_tuples = list(topic_tuples)
        self.timeout = timeout
        self.messages_received_buffer_length = messages_received_buffer_length
        self.trigger = trigger
        self._all_here = Event()
        self._messages: dict[str, deque[Any]] = {}
        self._context: Any = Context()
        rclpy.init(context=self._context)
        self._node: Any = rclpy.create_node('wait_for_topics', context=self._context)
        for topic, message_class, *qos in self.topic_tuples:
            self._messages[topic] = deque(maxlen=messages_received_buffer_length)
            self._node.create_subscription(message_class, topic, self._callback(topic), qos[0] if qos else 10)
        self._pump = MessagePump(self._node, context=self._context)
        self._pump.start()

    def __enter__(self) -> WaitForTopics:
        if not self.wait():
            missing = self.topics_not_received()
            self.shutdown()
            raise RuntimeError('Did not receive messages on these topics: ', missing)
        return self

    def __exit__(self, *_: object) -> None:
        self.shutdown()

    def wait(self, *args: Any, **kwargs: Any) -> bool:
        """Wait for the messages. Return False if a topic had no message in time. The arguments are passed to the trigger."""
        if self.trigger is not None:
            self.trigger(self._node, *args, **kwargs)
        return self._all_here.wait(self.timeout)

    def received_messages(self, topic_name: str) -> list[Any]:
        """Return the messages of a topic, the oldest first.

        :raises KeyError: for a topic that was not passed to the constructor.
        """
        return list(self._messages[topic_name])

    def topics_received(self) -> set[str]:
        """Return the topics on which a message has arrived."""
        return {topic for topic, messages in self._messages.items() if messages}

    def topics_not_received(self) -> set[str]:
        """Return the topics on which no message has arrived yet."""
        return set(self._messages) - self.topics_received()

    def shutdown(self) -> None:
        """Destroy the node."""
        self._pump.stop()
        self._node.destroy_node()
        if self._context.ok():
            self._context.shutdown()

    def _callback(self, topic: str) -> Callable[[Any], None]:
        def note(message: Any) -> None:
            self._messages[topic].append(message)
            if all(self._messages.values()):
                self._all_here.set()

        return note
