"""The graph in both peers: each peer repeats the changes of the other peer, and messages reach the subscriptions of both peers.

Each peer has every node and endpoint, in the same order and with the same numbers. The endpoints of the other peer are *remote*:
a message for such an endpoint is sent over the link, instead of into a queue.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from struct import Struct
from typing import TYPE_CHECKING, Any

from edulaunch.engine.graph.graph import Graph
from edulaunch.engine.graph.node_entry import NodeEntry
from edulaunch.engine.graph.qos import (
    AUTOMATIC,
    BEST_EFFORT,
    KEEP_ALL,
    KEEP_LAST,
    MANUAL_BY_TOPIC,
    RELIABLE,
    TRANSIENT_LOCAL,
    VOLATILE,
    QoS,
)
from edulaunch.engine.graph.services import ServiceClient, ServiceServer
from edulaunch.engine.graph.topics import Publisher, Subscription, WatchedPublisher, connect
from edulaunch.runtime.link.codec import AS_BEFORE, FrameKind, Messages, Violation, dump, load
from edulaunch.runtime.link.peer import Peer

if TYPE_CHECKING:
    from edulaunch.engine.graph.tracer import Record

END = Struct('<I')
ENDS = Struct('<II')
NUMBER = Struct('<Q')
NAME = re.compile(r'/[A-Za-z0-9_/~{}]{0,300}')
TYPE = re.compile(r'[A-Za-z0-9_/]{1,300}')
MOST_ENDS = 20_000
LAST_INDEX = (1 << 32) - 1
POLICIES = ((RELIABLE, BEST_EFFORT), (VOLATILE, TRANSIENT_LOCAL), (KEEP_LAST, KEEP_ALL), (AUTOMATIC, MANUAL_BY_TOPIC))


class RemoteQueue:
    """The queue of a remote endpoint. It holds a message until `on_ready` sends it. Old samples are not sent, because the other
    peer already has them.
    """

    item: Any = None

    def append(self, item: Any) -> None:
        self.item = item

    def extend(self, items: Any) -> None:
        """Append nothing, because the other peer already has the old samples."""

    def clear(self) -> None:
        """Do nothing, because the queue is always empty."""

    def __bool__(self) -> bool:
        return False


class Replica:
    """Keeps the graph of one peer equal to the graph of the other peer.

    :param process: a function that returns the program for a process ID of the other peer, for nodes of that peer.
    """

    def __init__(self, peer: Peer, graph: Graph, messages: Messages, process: Callable[[int], Any]) -> None:
        self.peer = peer
        self.graph = graph
        self.messages = messages
        self.is_repeating = False
        self.theirs: dict[int, Any] = {}
        self._process = process
        self._ours: dict[int, Any] = {}
        self._known: dict[int, tuple[Any, int, int]] = {}  # last message of each publisher that the other peer received
        peer.handlers.update(
            {
                FrameKind.NODE: self._node,
                FrameKind.NODE_GONE: self._node_gone,
                FrameKind.END: self._end,
                FrameKind.END_GONE: self._end_gone,
                FrameKind.PUBLISH: self._publish,
                FrameKind.READY: self._ready,
                FrameKind.ALIVE: lambda payload: self._of(payload, WatchedPublisher).show_life(),
                FrameKind.RESPONSE: self._response,
            }
        )
        peer.calls[FrameKind.REQUEST] = self._request

    # Changes here are sent to the other peer

    def node_added(self, node: NodeEntry) -> None:
        """Implement `Tracer.node_added`."""
        if not self.is_repeating:
            self.peer.tell(FrameKind.NODE, dump([node.index, node.process.pid, node.name, node.namespace]))

    def node_removed(self, node: NodeEntry) -> None:
        """Implement `Tracer.node_removed`."""
        if not self.is_repeating:
            self.peer.tell(FrameKind.NODE_GONE, END.pack(node.index))

    def endpoint_added(self, kind: str, end: Any) -> None:
        """Implement `Tracer.endpoint_added`."""
        if self.is_repeating:
            return
        self._ours[end.index] = end
        name = end.topic_name if kind in ('publisher', 'subscription') else end.service_name
        self.peer.tell(FrameKind.END, dump([kind, end.index, end.node.index, name, end.type_name, list(end.qos)]))
        if isinstance(end, WatchedPublisher):
            end.on_life.append(lambda: self.peer.tell(FrameKind.ALIVE, END.pack(end.index)))

    def endpoint_removed(self, kind: str, end: Any) -> None:
        """Implement `Tracer.endpoint_removed`."""
        self._known.pop(end.index, None)
        if not self.is_repeating:
            del self._ours[end.index]
            self.peer.tell(FrameKind.END_GONE, END.pack(end.index))

    def is_ours(self, end: Any) -> bool:
        """Return whether an endpoint belongs to a node of this peer."""
        return end.index in self._ours

    def published(self, publisher: Any, record: Record) -> None:
        """Send a message to the other peer before its delivery."""
        _, index, wire = record
        self._known[index] = wire, record[0], publisher.published
        self.peer.send(FrameKind.PUBLISH, END.pack(index) + self.messages.packed(publisher.cls, wire))

    def _deliver(self, subscription: Any) -> None:
        """Send a message that has reached a remote subscription."""
        if self.is_repeating:
            return
        wire, now_ns, publisher, number = subscription.queue.item
        known = self._known.get(publisher.index)
        if known is not None and known[0] is wire and known[1:] == (now_ns, number):
            message = bytes((AS_BEFORE,))
        else:
            self._known[publisher.index] = wire, now_ns, number
            message = self.messages.packed(publisher.cls, wire) + NUMBER.pack(number)
        self.peer.tell(FrameKind.READY, ENDS.pack(subscription.index, publisher.index) + message)

    def _ask(self, server: Any) -> None:
        """Send a request that has reached a remote server."""
        wire, (client, sequence) = server.queue.item
        data = self.messages.packed(client.cls.Request, wire)
        self.peer.call(FrameKind.REQUEST, [server.index, client.index, sequence, data])

    def _respond(self, client: Any) -> None:
        """Send a reply that has reached a remote client."""
        sequence, wire = client.queue.item
        data = self.messages.packed(client.cls.Response, wire)
        self.peer.tell(FrameKind.RESPONSE, dump([client.index, sequence, data]))

    # Changes of the other peer are repeated here

    def their(self, index: int, kind: type[Any]) -> Any:
        """Return the other peer's node or endpoint with that number. Raise Violation if it is not of the type `kind`."""
        found = self.theirs.get(index)
        if not isinstance(found, kind):
            raise Violation(f'number {index} is not a {kind.__name__} of that peer')
        return found

    def our(self, index: int, kind: type[Any]) -> Any:
        """Return this peer's endpoint with that number, or None if it no longer exists."""
        found = self._ours.get(index)
        return found if isinstance(found, kind) else None

    def _of(self, payload: memoryview, kind: type[Any]) -> Any:
        return self.their(END.unpack_from(payload)[0], kind)

    def _repeat(self, act: Callable[[], Any]) -> Any:
        before, self.is_repeating = self.is_repeating, True
        try:
            return act()
        finally:
            self.is_repeating = before

    def _node(self, payload: memoryview) -> None:
        index, pid, name, namespace = load(bytes(payload))
        self._take(index, lambda: self.graph.add_node(self._process(pid), _name(name, '/'), _name(namespace)))

    def _node_gone(self, payload: memoryview) -> None:
        node = self._of(payload, NodeEntry)
        if node.endpoints:
            raise Violation('a node must be removed after its endpoints')
        del self.theirs[node.index]
        self._repeat(lambda: self.graph.remove_node(node))

    def _take(self, index: int, make: Callable[[], Any]) -> None:
        """Repeat an addition in the other peer's graph, with the same number."""
        if not self.graph.last_index < index <= LAST_INDEX or len(self.theirs) >= MOST_ENDS:
            raise Violation('nodes and endpoints must be numbered in order')
        self.graph.last_index = index - 1
        self.theirs[index] = self._repeat(make)

    def _end(self, payload: memoryview) -> None:
        kind, index, node, name, type_name, qos = load(bytes(payload))
        if not isinstance(type_name, str) or not TYPE.fullmatch(type_name):
            raise Violation('no type')
        make = getattr(self, f'_{kind}')
        entry = self.their(node, NodeEntry)
        self._take(index, lambda: make(entry, _name(name), self.messages.type(type_name), _qos(qos)))

    def _publisher(self, node: NodeEntry, topic: str, cls: Any, qos: QoS) -> Publisher:
        return self.graph.create_publisher(node, topic, cls, qos)

    def _subscription(self, node: NodeEntry, topic: str, cls: Any, qos: QoS) -> Subscription:
        subscription = Subscription(self.graph, node, topic, cls, qos, lambda: self._deliver(subscription))
        subscription.queue = RemoteQueue()  # type: ignore[assignment]
        self.graph.add_end(node, self.graph.subscriptions, topic, subscription)
        for publisher in self.graph.publishers.get(topic, ()):
            connect(publisher, subscription)
        return subscription

    def _service(self, node: NodeEntry, name: str, cls: Any, qos: QoS) -> ServiceServer:
        server = self.graph.create_service(node, name, cls, qos, lambda: self._ask(server))
        server.queue = RemoteQueue()  # type: ignore[assignment]
        return server

    def _client(self, node: NodeEntry, name: str, cls: Any, qos: QoS) -> ServiceClient:
        client = self.graph.create_client(node, name, cls, qos, lambda: self._respond(client))
        client.queue = RemoteQueue()  # type: ignore[assignment]
        return client

    def _end_gone(self, payload: memoryview) -> None:
        end = self._of(payload, object)
        if isinstance(end, NodeEntry):
            raise Violation('a node is not an endpoint')
        del self.theirs[end.index]
        self._repeat(end.destroy)

    def _publish(self, payload: memoryview) -> None:
        publisher = self._of(payload, Publisher)
        wire = self.messages.unpacked(publisher.cls, bytes(payload[END.size :]))
        now_ns = self.graph.sim.now_ns
        publisher.published += 1
        publisher.record((now_ns, publisher.index, wire))
        if publisher.history is not None:
            publisher.history.append((wire, now_ns, publisher, publisher.published))
        self._known[publisher.index] = wire, now_ns, publisher.published

    def _ready(self, payload: memoryview) -> None:
        subscription_index, publisher_index = ENDS.unpack_from(payload)
        publisher = self.their(publisher_index, Publisher)
        data = bytes(payload[ENDS.size :])
        if data[:1] != bytes((AS_BEFORE,)):
            if len(data) < NUMBER.size:
                raise Violation('a message without its number')
            (number,) = NUMBER.unpack(data[-NUMBER.size :])
            wire = self.messages.unpacked(publisher.cls, data[: -NUMBER.size])
            self._known[publisher_index] = wire, self.graph.sim.now_ns, number
        wire, at_ns, number = self._known[publisher_index]
        subscription = self.our(subscription_index, Subscription)
        if subscription is not None:
            if subscription not in publisher.matched:
                raise Violation('a message to an endpoint that is not a subscription of its topic')
            subscription.queue.append((wire, at_ns, publisher, number))
            subscription.on_ready()

    def _request(self, payload: memoryview) -> None:
        server_index, client_index, sequence, data = load(bytes(payload))
        client = self.their(client_index, ServiceClient)
        wire = self.messages.unpacked(client.cls.Request, data)
        server = self.our(server_index, ServiceServer)
        if server is not None:
            if server not in client.servers() or not isinstance(sequence, int):
                raise Violation('a request to an endpoint that does not serve it')
            client.unanswered.add(sequence)
            server.queue.append((wire, (client, sequence)))
            server.on_ready()

    def _response(self, payload: memoryview) -> None:
        client_index, sequence, data = load(bytes(payload))
        client = self.our(client_index, ServiceClient)
        if client is None or sequence not in client.unanswered:
            return
        wire = self.messages.unpacked(client.cls.Response, data)
        client.unanswered.remove(sequence)
        self.answered(client, sequence, wire)
        client.queue.append((sequence, wire))
        client.on_ready()

    def answered(self, client: Any, sequence: int, wire: Any) -> None:
        """Record a reply from the other peer to a client of this peer.

        Only the trusted peer replaces this method, which does nothing here.
        """


def _name(value: Any, before: str = '') -> str:
    if not isinstance(value, str) or not NAME.fullmatch(before + value):
        raise Violation('no name')
    return value


def _qos(values: Any) -> QoS:
    qos = QoS(*values)
    numbers = (qos.depth, qos.deadline_ns, qos.lifespan_ns, qos.lease_ns)
    if not all(type(number) is int and 0 <= number < 1 << 63 for number in numbers):
        raise Violation('invalid quality of service')
    words = (qos.reliability, qos.durability, qos.history, qos.liveliness)
    if not all(word in known for word, known in zip(words, POLICIES, strict=True)):
        raise Violation('invalid quality of service')
    return qos
