"""What is on the network, as the graph of the machine shows it: nodes and endpoints that stand for real ones.

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
    """In the place of the program of a node on the network."""

    name = 'network'
    pid = 0

    def __init__(self) -> None:
        self.state: dict[str, Any] = {}


class TypeName:
    """In the place of a message class that nobody here has."""

    def __init__(self, name: str) -> None:
        self.TYPE = name


class NullQueue:
    """In the place of a queue that nobody reads: `last` is what came last."""

    last: Any = None

    def append(self, item: Any) -> None:
        """Somebody sent it."""
        self.last = item

    def clear(self) -> None:
        """Nothing waits here."""

    def extend(self, items: Any) -> None:
        """Old samples go out by the link itself."""


class RemotePublisher(Publisher):
    """A publisher on the network: its messages come to the subscriptions of the link, not from here."""

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


class RemoteSubscription(Subscription):
    """A subscription on the network: the link itself reaches it."""

    def __init__(self, graph: Graph, node: NodeEntry, name: str, cls: Any, qos: QoS) -> None:
        super().__init__(graph, node, name, cls, qos, lambda: None)
        self.queue = NullQueue()  # type: ignore[assignment]


class RemoteService(ServiceServer):
    """A service on the network.

    :param ask: called with each request as it comes: (wire, (client, number)).
    """

    def __init__(self, graph: Graph, node: NodeEntry, name: str, cls: Any, qos: QoS, ask: Callable[[Any], object]) -> None:
        super().__init__(graph, node, name, cls, qos, lambda: ask(self.queue.last))  # type: ignore[attr-defined]
        self.queue = NullQueue()  # type: ignore[assignment]


class RemoteClient(ServiceClient):
    """A client on the network, for those who count."""

    def __init__(self, graph: Graph, node: NodeEntry, name: str, cls: Any, qos: QoS) -> None:
        super().__init__(graph, node, name, cls, qos, lambda: None)


def is_remote(node: NodeEntry) -> bool:
    """Whether a node of the graph stands for a real one."""
    return isinstance(node.process, Network)


def named(node: NodeEntry) -> str:
    """The name of a node for a sentence; endpoints that no node has claimed belong to one without a name."""
    return 'a node that has not told its name' if node.name == UNKNOWN_NAME else node.fully_qualified_name


def join(end: Any) -> None:
    """Let an endpoint on the network be seen here, and meet its counterparts here."""
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
