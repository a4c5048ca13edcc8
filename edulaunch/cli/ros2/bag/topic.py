"""One recorded topic."""

from __future__ import annotations

from typing import Any

from edulaunch.graph import qos
from edulaunch.graph.graph import NodeEntry
from edulaunch.graph.topics import Publisher

BagMessage = tuple[int, str, Any]
"""Time of arrival in ns, topic, wire tuple."""


class BagTopic:
    """Takes the messages of a topic straight from the graph: no turn of the recorder for each, no copy.

    :param publishers: those there are; the subscription is as reliable and as durable as all of them are.
    :param messages: what arrives is appended here.
    """

    def __init__(self, node: NodeEntry, publishers: list[Publisher], messages: list[BagMessage]) -> None:
        first = publishers[0]
        self.name = first.topic_name
        self.cls = first.cls
        self.offered = [publisher.qos for publisher in publishers]
        self._keep = messages.append
        self._sim = node.process.sim
        self.is_paused = False
        self._queue: Any = ()
        subscription = first.graph.create_subscription(node, self.name, self.cls, _suitable(self.offered), self._on_ready)
        self._queue = subscription.queue
        self._on_ready()

    def _on_ready(self) -> None:
        while self._queue:
            wire = self._queue.popleft()[0]
            if not self.is_paused:
                self._keep((self._sim.now_ns, self.name, wire))


def _suitable(offered: list[qos.QoS]) -> qos.QoS:
    reliable = all(each.reliability == qos.RELIABLE for each in offered)
    kept = all(each.durability == qos.TRANSIENT_LOCAL for each in offered)
    return qos.QoS(
        reliability=qos.RELIABLE if reliable else qos.BEST_EFFORT,
        durability=qos.TRANSIENT_LOCAL if kept else qos.VOLATILE,
        history=qos.KEEP_ALL,
    )
