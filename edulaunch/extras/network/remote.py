"""Nodes and endpoints in the machine's graph that represent real nodes and endpoints on the network.

No message passes between two of them, because the real endpoints communicate directly. Two bridges therefore form no loop.
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
"""ROS 2's name for the node of an endpoint that no node has claimed."""


class Network:
    """Represents the program of a node on the network."""

    name = 'network'
    pid = 0

    def __init__(self) -> None:
        self.state: dict[str, Any] = {}


class TypeName:
    """Represents a message class that is unknown here."""

    def __init__(self, name: str) -> None:
        self.TYPE = name


class NullQueue:
    """A queue without a reader. `last` is the last message."""

    last: Any = None

    def append(self, item: Any) -> None:
        """Store the message as the last message."""
        self.last = item

    def clear(self) -> None:
        """Do nothing, because the queue is always empty."""

    def extend(self, items: Any) -> None:
        """Do nothing, because the link itself sends old samples."""


class RemotePublisher(Publisher):
    """A publisher on the network. The link, not this object, passes its messages to subscriptions."""

    def __init__(self, graph: Graph, node: NodeEntry, name: str, cls: Any, qos: QoS) -> None:
        Endpoint.__init__(self, graph, node, name, cls, qos)
        self._sim = graph.sim
        self.matched = []
        self.history = None
        self.published = 0
        self._channel: Callable[[Any], object] | None = None

    def record(self, wire: Any) -> None:
        """Record a message of this publisher."""
        if self._channel is None:
            self._channel = self.graph.tracer.channel(self)
        self.published += 1
        self._channel((self._sim.now_ns, self.index, wire))


class RemoteSubscription(Subscription):
    """A subscription on the network, to which the link sends directly."""

    def __init__(self, graph: Graph, node: NodeEntry, name: str, cls: Any, qos: QoS) -> None:
        super().__init__(graph, node, name, cls, qos, lambda: None)
        self.queue = NullQueue()  # type: ignore[assignment]


class RemoteService(ServiceServer):
    """A service on the network.

    :param ask: called with each request, as (wire tuple, (client, number)).
    """

    def __init__(self, graph: Graph, node: NodeEntry, name: str, cls: Any, qos: QoS, ask: Callable[[Any], object]) -> None:
        super().__init__(graph, node, name, cls, qos, lambda: ask(self.queue.last))  # type: ignore[attr-defined]
        self.queue = NullQueue()  # type: ignore[assignment]


class RemoteClient(ServiceClient):
    """A client on the network, which is only counted and listed."""

    def __init__(self, graph: Graph, node: NodeEntry, name: str, cls: Any, qos: QoS) -> None:
        super().__init__(graph, node, name, cls, qos, lambda: None)


def is_remote(node: NodeEntry) -> bool:
    """Return whether a node of the graph represents a real node."""
    return isinstance(node.process, Network)


def named(node: NodeEntry) -> str:
    """Return the name of a node for a message. Endpoints that no node has claimed belong to a node without a name."""
    return 'a node with an unknown name' if node.name == UNKNOWN_NAME else node.fully_qualified_name


def join(end: Any) -> None:
    """Add an endpoint of the network to this graph, and match it with the endpoints of this machine."""
    graph = end.graph
    if isinstance(end, RemotePublisher):
        graph.add_end(end.node, graph.publishers, end.topic_name, end)
        for subscription in graph.subscriptions.get(end.topic_name, ()):
            if not isinstance(subscription, RemoteSubscription):
                connect(end, subscription)
    elif isinstance(end, RemoteSubscription):
        graph.add_end(end.node, graph.subscriptions, end.topic_name, end)
        for publisher in graph.publishers.get(end.topic_name, ()):
            if not isinstance(publisher, RemotePublisher):
                connect(publisher, end)
    elif isinstance(end, RemoteService):
        graph.add_end(end.node, graph.services, end.service_name, end)
    else:
        graph.add_end(end.node, graph.clients, end.service_name, end)
