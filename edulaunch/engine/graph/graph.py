"""The graph of one simulation: who is there, and who hears whom."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from edulaunch.engine.graph.qos import QoS
from edulaunch.engine.graph.services import ServiceClient, ServiceServer
from edulaunch.engine.graph.topics import Publisher, Subscription, WatchedPublisher, connect, disconnect
from edulaunch.engine.graph.tracer import Tracer
from edulaunch.engine.sim.simulation import Simulation


class NodeEntry:
    """A node as the graph knows it. `endpoints` are in order of creation.

    :ivar participant: what all endpoints of one DDS participant share: the process, or the context that made the node.
    """

    def __init__(self, process: Any, name: str, namespace: str, index: int) -> None:
        self.process = process
        self.name = name
        self.namespace = namespace
        self.index = index
        self.participant: object = process
        self.endpoints: list[Any] = []

    @property
    def fully_qualified_name(self) -> str:
        """The namespace and the name, such as '/turtlesim2/sim'."""
        return ('' if self.namespace == '/' else self.namespace) + '/' + self.name

    @property
    def logger_name(self) -> str:
        """The full name with dots: 'a.b.c' for node c in /a/b."""
        return self.fully_qualified_name[1:].replace('/', '.')

    def __repr__(self) -> str:
        return f'<node {self.fully_qualified_name}>'


class Graph:
    """Nodes and endpoints of one simulation. All names given to it are fully expanded and remapped already.

    Two nodes may have the same name, as in ROS 2. `changes` counts up whenever anything comes or goes.
    """

    def __init__(self, sim: Simulation, tracer: Tracer | None = None) -> None:
        self.sim = sim
        self.tracer = tracer if tracer is not None else Tracer()
        self.nodes: list[NodeEntry] = []
        self.publishers: dict[str, list[Publisher]] = {}
        self.subscriptions: dict[str, list[Subscription]] = {}
        self.services: dict[str, list[ServiceServer]] = {}
        self.clients: dict[str, list[ServiceClient]] = {}
        self.changes = 0
        self.on_change: list[Callable[[], object]] = []
        self.last_index = 0

    def next_index(self) -> int:
        """The next number in order of creation, for nodes and endpoints alike."""
        self.last_index += 1
        return self.last_index

    def _changed(self) -> None:
        self.changes += 1
        for callback in list(self.on_change):
            callback()

    def add_node(self, process: Any, name: str, namespace: str) -> NodeEntry:
        """Let a node join; `namespace` is absolute ('/' for the root)."""
        node = NodeEntry(process, name, namespace, self.next_index())
        self.nodes.append(node)
        self.tracer.node_added(node)
        self._changed()
        return node

    def remove_node(self, node: NodeEntry) -> None:
        """Let a node leave, with all its endpoints. Doing it twice is doing it once."""
        if node not in self.nodes:
            return
        self.tracer.node_leaving(node)
        for endpoint in list(node.endpoints):
            endpoint.destroy()
        self.nodes.remove(node)
        self.tracer.node_removed(node)
        self._changed()

    def remove_process(self, process: Any) -> None:
        """Let all nodes of a process leave, as when the process has ended."""
        for node in [node for node in self.nodes if node.process is process]:
            self.remove_node(node)

    def create_publisher(self, node: NodeEntry, topic: str, cls: Any, qos: QoS) -> Publisher:
        """A publisher of `node`, connected to all subscriptions that it suits."""
        made = WatchedPublisher if qos.deadline_ns or qos.lease_ns else Publisher
        publisher = made(self, node, topic, cls, qos)
        self.add_end(node, self.publishers, topic, publisher)
        for subscription in self.subscriptions.get(topic, ()):
            connect(publisher, subscription)
        return publisher

    def create_subscription(
        self, node: NodeEntry, topic: str, cls: Any, qos: QoS, on_ready: Callable[[], object]
    ) -> Subscription:
        """A subscription of `node`, connected to all publishers that suit it; old samples may stand in its queue at once."""
        subscription = Subscription(self, node, topic, cls, qos, on_ready)
        self.add_end(node, self.subscriptions, topic, subscription)
        for publisher in self.publishers.get(topic, ()):
            connect(publisher, subscription)
        return subscription

    def create_service(self, node: NodeEntry, name: str, cls: Any, qos: QoS, on_ready: Callable[[], object]) -> ServiceServer:
        """A server of `node`. All servers of one name get each request, and the client hears the first reply."""
        server = ServiceServer(self, node, name, cls, qos, on_ready)
        self.add_end(node, self.services, name, server)
        return server

    def create_client(self, node: NodeEntry, name: str, cls: Any, qos: QoS, on_ready: Callable[[], object]) -> ServiceClient:
        """A client of `node`."""
        client = ServiceClient(self, node, name, cls, qos, on_ready)
        self.add_end(node, self.clients, name, client)
        return client

    def servers_for(self, client: ServiceClient) -> list[ServiceServer]:
        """The servers that would get a request of `client` now, in order of creation."""
        return [server for server in self.services.get(client.service_name, ()) if server.type_name == client.type_name]

    def remove_publisher(self, publisher: Publisher) -> None:
        """See `Publisher.destroy`. What a dying program publishes afterwards is not recorded."""
        publisher.record = _forget
        for subscription in list(publisher.matched):
            disconnect(publisher, subscription)
        self._remove(self.publishers, publisher.topic_name, publisher)

    def remove_subscription(self, subscription: Subscription) -> None:
        """See `Subscription.destroy`."""
        for publisher in list(subscription.publishers):
            disconnect(publisher, subscription)
        subscription.queue.clear()
        self._remove(self.subscriptions, subscription.topic_name, subscription)

    def remove_service(self, server: ServiceServer) -> None:
        """See `ServiceServer.destroy`."""
        self._remove(self.services, server.service_name, server)

    def remove_client(self, client: ServiceClient) -> None:
        """See `ServiceClient.destroy`."""
        self._remove(self.clients, client.service_name, client)

    def add_end(self, node: NodeEntry, table: dict[str, list[Any]], name: str, endpoint: Any) -> None:
        table.setdefault(name, []).append(endpoint)
        node.endpoints.append(endpoint)
        self.tracer.endpoint_added(endpoint.kind, endpoint)
        self._changed()

    def _remove(self, table: dict[str, list[Any]], name: str, endpoint: Any) -> None:
        if endpoint.destroyed:
            return
        endpoint.destroyed = True
        table[name].remove(endpoint)
        if not table[name]:
            del table[name]
        endpoint.node.endpoints.remove(endpoint)
        self.tracer.endpoint_removed(endpoint.kind, endpoint)
        self._changed()


def _forget(record: Any) -> None:
    """Takes the place of what records the messages of a publisher."""
