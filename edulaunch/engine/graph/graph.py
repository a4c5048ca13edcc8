"""The graph of one simulation. It connects publishers with subscriptions, and clients with servers."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from edulaunch.engine.graph.members import Members
from edulaunch.engine.graph.node_entry import NodeEntry
from edulaunch.engine.graph.qos import QoS
from edulaunch.engine.graph.services import ServiceClient, ServiceServer
from edulaunch.engine.graph.topics import Publisher, Subscription, WatchedPublisher, connect


class Graph(Members):
    """The nodes and endpoints of one simulation. All names that are passed to a graph must already be expanded and remapped.

    Two nodes may have the same name, as in ROS 2.
    """

    publishers: dict[str, list[Publisher]]
    subscriptions: dict[str, list[Subscription]]
    services: dict[str, list[ServiceServer]]
    clients: dict[str, list[ServiceClient]]

    def create_publisher(self, node: NodeEntry, topic: str, cls: Any, qos: QoS) -> Publisher:
        """Return a new publisher of `node`, connected to all compatible subscriptions."""
        made = WatchedPublisher if qos.deadline_ns or qos.lease_ns else Publisher
        publisher = made(self, node, topic, cls, qos)
        self.add_end(node, self.publishers, topic, publisher)
        for subscription in self.subscriptions.get(topic, ()):
            connect(publisher, subscription)
        return publisher

    def create_subscription(
        self, node: NodeEntry, topic: str, cls: Any, qos: QoS, on_ready: Callable[[], object]
    ) -> Subscription:
        """Return a new subscription of `node`, connected to all compatible publishers.

        The queue of the subscription may contain stored messages of transient local publishers from the start.
        """
        subscription = Subscription(self, node, topic, cls, qos, on_ready)
        self.add_end(node, self.subscriptions, topic, subscription)
        for publisher in self.publishers.get(topic, ()):
            connect(publisher, subscription)
        return subscription

    def create_service(self, node: NodeEntry, name: str, cls: Any, qos: QoS, on_ready: Callable[[], object]) -> ServiceServer:
        """Return a new server of `node`.

        All servers of a service get each request, and the client receives the first reply.
        """
        server = ServiceServer(self, node, name, cls, qos, on_ready)
        self.add_end(node, self.services, name, server)
        return server

    def create_client(self, node: NodeEntry, name: str, cls: Any, qos: QoS, on_ready: Callable[[], object]) -> ServiceClient:
        """Return a new client of `node`."""
        client = ServiceClient(self, node, name, cls, qos, on_ready)
        self.add_end(node, self.clients, name, client)
        return client
