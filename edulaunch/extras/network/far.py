"""What is far away, as the graph of the machine shows it: nodes and endpoints that stand for real ones.

Nothing passes from one of them to another: the real ones hear each other without us, and two bridges make no loop.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from edulaunch.engine.graph.graph import Graph
from edulaunch.engine.graph.node_entry import NodeEntry
from edulaunch.engine.graph.qos import QoS
from edulaunch.engine.graph.services import ServiceClient, ServiceServer
from edulaunch.engine.graph.topics import Endpoint, Publisher, Subscription, connect

UNKNOWN_NAME, UNKNOWN_NAMESPACE = '_NODE_NAME_UNKNOWN_', '_NODE_NAMESPACE_UNKNOWN_'
"""What ROS 2 says of an endpoint that no node has claimed."""


class Network:
    """In the place of the program of a node that is far away."""

    name = 'network'
    pid = 0

    def __init__(self) -> None:
        self.state: dict[str, Any] = {}


class TypeName:
    """In the place of a message class that nobody here has."""

    def __init__(self, name: str) -> None:
        self.TYPE = name


class Nowhere:
    """In the place of a queue that nobody reads: `last` is what came last."""

    last: Any = None

    def append(self, item: Any) -> None:
        """Somebody sent it."""
        self.last = item

    def clear(self) -> None:
        """Nothing waits here."""

    def extend(self, items: Any) -> None:
        """Old samples go out by the link itself."""


class FarPublisher(Publisher):
    """A publisher that is far away: its messages come to the subscriptions of the link, not from here."""

    def __init__(self, graph: Graph, node: NodeEntry, name: str, cls: Any, qos: QoS) -> None:
        Endpoint.__init__(self, graph, node, name, cls, qos)
        self._sim = graph.sim
        self.matched = []
        self.history = None
        self._channel: Callable[[Any], object] | None = None

    def heard(self, wire: Any) -> None:
        """A message of it has come: for the record."""
        if self._channel is None:
            self._channel = self.graph.tracer.channel(self)
        self._channel((self._sim.now_ns, self.index, wire))


class FarSubscription(Subscription):
    """A subscription that is far away: the link itself reaches it."""

    def __init__(self, graph: Graph, node: NodeEntry, name: str, cls: Any, qos: QoS) -> None:
        super().__init__(graph, node, name, cls, qos, lambda: None)
        self.queue = Nowhere()  # type: ignore[assignment]


class FarService(ServiceServer):
    """A service that is far away.

    :param ask: called with each request as it comes: (wire, (client, number)).
    """

    def __init__(self, graph: Graph, node: NodeEntry, name: str, cls: Any, qos: QoS, ask: Callable[[Any], object]) -> None:
        super().__init__(graph, node, name, cls, qos, lambda: ask(self.queue.last))  # type: ignore[attr-defined]
        self.queue = Nowhere()  # type: ignore[assignment]


class FarClient(ServiceClient):
    """A client that is far away, for those who count."""

    def __init__(self, graph: Graph, node: NodeEntry, name: str, cls: Any, qos: QoS) -> None:
        super().__init__(graph, node, name, cls, qos, lambda: None)


def is_far(node: NodeEntry) -> bool:
    """Whether a node of the graph stands for a real one."""
    return isinstance(node.process, Network)


def named(node: NodeEntry) -> str:
    """The name of a node for a sentence; endpoints that no node has claimed belong to one without a name."""
    return 'a node that has not told its name' if node.name == UNKNOWN_NAME else node.fully_qualified_name


def join(end: Any) -> None:
    """Let an endpoint that is far away be seen here, and meet its counterparts here."""
    graph = end.graph
    if isinstance(end, FarPublisher):
        graph.add_end(end.node, graph.publishers, end.topic_name, end)
        for subscription in graph.subscriptions.get(end.topic_name, ()):
            if not isinstance(subscription, FarSubscription):
                connect(end, subscription)
    elif isinstance(end, FarSubscription):
        graph.add_end(end.node, graph.subscriptions, end.topic_name, end)
        for publisher in graph.publishers.get(end.topic_name, ()):
            if not isinstance(publisher, FarPublisher):
                connect(publisher, end)
    elif isinstance(end, FarService):
        graph.add_end(end.node, graph.services, end.service_name, end)
    else:
        graph.add_end(end.node, graph.clients, end.service_name, end)
