"""The graph of one simulation: publishers and subscriptions find each other, and clients find their servers."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from edulaunch.engine.graph.members import Members
from edulaunch.engine.graph.node_entry import NodeEntry
from edulaunch.engine.graph.qos import QoS
from edulaunch.engine.graph.services import ServiceClient, ServiceServer
from edulaunch.engine.graph.topics import Publisher, Subscription, WatchedPublisher, connect


class Graph(Members):
    """Nodes and endpoints of one simulation. All names passed to it are fully expanded and remapped already.

    Two nodes may have the same name, as in ROS 2.
    """

    publishers: dict[str, list[Publisher]]
    subscriptions: dict[str, list[Subscription]]
    services: dict[str, list[ServiceServer]]
    clients: dict[str, list[ServiceClient]]

    def create_publisher(self, node: NodeEntry, topic: str, cls: Any, qos: QoS) -> Publisher:
        """Return a publisher of `node`, connected to all compatible subscriptions."""
        made = WatchedPublisher if qos.deadline_ns or qos.lease_ns else Publisher
        publisher = made(self, node, topic, cls, qos)
        self.add_end(node, self.publishers, topic, publisher)
        for subscription in self.subscriptions.get(topic, ()):
            connect(publisher, subscription)
        return publisher

    def create_subscription(
        self, node: NodeEntry, topic: str, cls: Any, qos: QoS, on_ready: Callable[[], object]
    ) -> Subscription:
        """Add a subscription of `node`, and connect it to all compatible publishers; its queue may receive old samples
        immediately.
        """
        subscription = Subscription(self, node, topic, cls, qos, on_ready)
        self.add_end(node, self.subscriptions, topic, subscription)
        for publisher in self.publishers.get(topic, ()):
            connect(publisher, subscription)
        return subscription

    def create_service(self, node: NodeEntry, name: str, cls: Any, qos: QoS, on_ready: Callable[[], object]) -> ServiceServer:
        """Add a server of `node`. All servers of one name get each request, and the client receives the first reply."""
        server = ServiceServer(self, node, name, cls, qos, on_ready)
        self.add_end(node, self.services, name, server)
        return server

    def create_client(self, node: NodeEntry, name: str, cls: Any, qos: QoS, on_ready: Callable[[], object]) -> ServiceClient:
        """Return a client of `node`."""
        client = ServiceClient(self, node, name, cls, qos, on_ready)
        self.add_end(node, self.clients, name, client)
        return client
