"""The topics of a real network for `ros2 bag record`. In place of a graph, they provide the bytes of messages as they arrive."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

from rclpy.event_handler import SubscriptionEventCallbacks
from rclpy.executors import SingleThreadedExecutor

from edulaunch.engine.graph.qos import QoS
from edulaunch.engine.interfaces.importer import installed_registry
from edulaunch.errors import InterfaceError
from edulaunch.extras.native.qos import from_rclpy, to_rclpy

AT_ONCE = 100
"""The number of messages of one topic that one turn of the executor takes. A turn costs more than taking these messages."""


class BagTopics:
    """The publishers that the node `node` has discovered.

    :ivar entry: the object that represents the node.
    """

    def __init__(self, node: Any, process: Any) -> None:
        self._node = node
        self.entry = SimpleNamespace(process=process)
        self._unknown: set[str] = set()
        executor = SingleThreadedExecutor()
        executor.add_node(node)
        node.context.waits.append(executor.spin_once)

    @property
    def publishers(self) -> BagTopics:
        """Return the topics that can be recorded. The result supports `in` and `[]` with the name of a topic."""
        return self

    def __contains__(self, topic: str) -> bool:
        found = self._node.get_publishers_info_by_topic(topic)
        return bool(found) and self._class(topic, found[0].topic_type) is not None

    def __getitem__(self, topic: str) -> list[Any]:
        found = self._node.get_publishers_info_by_topic(topic)
        cls = SimpleNamespace(TYPE=found[0].topic_type)
        return [SimpleNamespace(graph=self, topic_name=topic, cls=cls, qos=QoS(*from_rclpy(each.qos_profile))) for each in found]

    def _class(self, topic: str, type_name: str) -> Any:
        registry = installed_registry()
        assert registry is not None
        try:
            return registry.get(type_name)
        except InterfaceError:
            if topic not in self._unknown:
                self._unknown.add(topic)
                text = f"Topic '{topic}' has unknown type '{type_name}'. Only topics with known type are supported."
                self._node.get_logger().warning(text)
            return None

    def create_subscription(self, entry: Any, topic: str, cls: Any, qos: QoS, on_ready: Callable[[], object]) -> Any:
        """Return a subscription. Its `queue` contains the bytes of each message when `on_ready` is called."""
        queue: deque[tuple[bytes]] = deque()
        kind = self._class(topic, cls.TYPE)

        def on_message(data: bytes, info: Any) -> None:
            taken: Any = (data, info)
            for _ in range(AT_ONCE):
                if taken is None:
                    break
                queue.append((bytes(taken[0]),))
                taken = made.handle.take_message(kind, True)
            on_ready()

        silent = SubscriptionEventCallbacks(use_default_callbacks=False)
        made = self._node.create_subscription(kind, topic, on_message, to_rclpy(qos), raw=True, event_callbacks=silent)
        return SimpleNamespace(queue=queue)
