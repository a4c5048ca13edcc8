"""A link with cyclonedds in this process. It carries topics and the graph with all peers, and services only with Cyclone DDS
peers.
"""

from __future__ import annotations

import os
import socket
from collections import deque
from collections.abc import Sequence
from contextlib import suppress
from importlib.metadata import version
from typing import Any

from cyclonedds._clayer import ddspy_get_matched_publication_data, ddspy_take, ddspy_write
from cyclonedds.core import DDSException, Listener
from cyclonedds.domain import DomainParticipant
from cyclonedds.pub import DataWriter
from cyclonedds.qos import Policy, Qos
from cyclonedds.sub import DataReader
from cyclonedds.topic import Topic

from edulaunch.engine.graph.qos import QoS
from edulaunch.extras.network.dds.discovery import ANY, Discovery, padded, reference
from edulaunch.extras.network.dds.domain import join, leave
from edulaunch.extras.network.dds.mangling import REPLY, REQUEST, TOPIC, topic_name
from edulaunch.extras.network.dds.qos import PLAIN, qos_from, to_dds
from edulaunch.extras.network.dds.service_peers import ServicePeers, is_fast_dds
from edulaunch.extras.network.dds.types import idl_class
from edulaunch.extras.network.network_link import (
    CLIENT,
    ENCLAVE,
    PUBLISHER,
    SERVICE,
    SUBSCRIPTION,
    Event,
    GraphChanged,
    Interface,
    LinkDiagnostic,
    LinkError,
    Message,
    RemoteGraph,
    Request,
    Response,
    Settings,
)

HEADER, ID = 4, 16
"""The bytes of a message's header, and of the ID that rmw_cyclonedds puts between header and request or reply."""
AT_ONCE = 100
"""The number of messages of one subscription that one turn of the machine takes."""
SIDES = {PUBLISHER: ('', TOPIC), SUBSCRIPTION: (TOPIC, ''), SERVICE: (REQUEST, REPLY), CLIENT: (REPLY, REQUEST)}
"""The readers and writers of each kind of endpoint."""


class End:
    """One endpoint of this link. While it is announced, it has a reader and a writer."""

    def __init__(self, node: int, kind: str, name: str, interface: Interface, qos: QoS) -> None:
        self.node, self.kind, self.name, self.interface, self.qos = node, kind, name, interface, qos
        self.reader: Any = None
        self.writer: Any = None
        self.is_marked = False
        self.id = os.urandom(8)
        self.writers: dict[int, bytes] = {}
        self.topics: list[tuple[str, str]] = []

    @property
    def is_on(self) -> bool:
        """Return whether other programs can see the endpoint."""
        return self.reader is not None or self.writer is not None


class CycloneLink:
    """The link with Cyclone DDS; see `network_link.Link`."""

    title = f'cyclonedds {version("cyclonedds")}'

    def __init__(self) -> None:
        self._count = 0
        self._nodes: dict[int, tuple[str, str]] = {}
        self._ends: dict[int, End] = {}
        self._topics: dict[tuple[str, str], Any] = {}
        self._marked: deque[int] = deque()
        self._events: list[Event] = []
        self._is_announced = True
        self._has_news = False
        self._participant: Any = None
        self._services = ServicePeers()
        self._wake_end, self._bell = socket.socketpair()
        for end in (self._wake_end, self._bell):
            end.setblocking(False)

    def open(self, settings: Settings) -> None:
        """Implement `Link.open`."""
        join(settings)
        self._domain = settings.domain
        try:
            self._participant = DomainParticipant(settings.domain, qos=Qos(Policy.Userdata(f'enclave={ENCLAVE};'.encode())))
        except DDSException as error:
            leave(settings.domain)
            raise LinkError(f'cannot join domain {settings.domain}: {error}') from None
        self._discovery = Discovery(self._participant, self._news)

    def add_node(self, namespace: str, name: str) -> int:
        """Implement `Link.add_node`."""
        self._count += 1
        self._nodes[self._count] = namespace, name
        self._is_announced = False
        return self._count

    def remove_node(self, handle: int) -> None:
        """Implement `Link.remove_node`."""
        del self._nodes[handle]
        self._is_announced = False

    def add(self, node: int, kind: str, name: str, interface: Interface, qos: QoS) -> int:
        """Add an endpoint; see `Link.add`. A service is announced when a peer exists that can use it."""
        self._count += 1
        handle, end = self._count, End(node, kind, name, interface, qos)
        self._ends[handle] = end
        if kind in (PUBLISHER, SUBSCRIPTION):
            try:
                self._begin(handle, end)
            except LinkError:
                del self._ends[handle]
                raise
        else:
            self._look_at_services()
        return handle

    def remove(self, handle: int) -> None:
        """Implement `Link.remove`."""
        self._stop(self._ends.pop(handle))
        self._is_announced = False

    def _begin(self, handle: int, end: End) -> None:
        """Announce an endpoint.

        :raises LinkError: when Cyclone DDS rejects it.
        """
        reads, writes = SIDES[end.kind]
        parts = ('', '') if not (reads and writes) else ('_Request', '_Response')[:: 1 if end.kind == SERVICE else -1]
        try:
            if reads:
                listener = Listener(on_data_available=lambda reader: self._mark(handle, end))
                topic = self._topic(reads, end, parts[0])
                end.reader = DataReader(
                    self._participant, topic, qos=to_dds(end.qos, end.interface.hash, True), listener=listener
                )
            if writes:
                topic = self._topic(writes, end, parts[1])
                end.writer = DataWriter(self._participant, topic, qos=to_dds(end.qos, end.interface.hash, False))
        except (DDSException, TypeError, ValueError) as error:
            self._stop(end)
            raise LinkError(f'{end.name} ({end.interface.name}) cannot cross: {error}') from None
        self._is_announced = False

    def _topic(self, prefix: str, end: End, part: str) -> Any:
        name, type_name = topic_name(prefix, end.name), end.interface.name + part
        if (name, type_name) not in self._topics:
            self._topics[name, type_name] = Topic(
                self._participant, name, idl_class(type_name, end.interface.registry, bool(part)), qos=Qos(PLAIN)
            )
        end.topics.append((name, type_name))
        return self._topics[name, type_name]

    def _stop(self, end: End) -> None:
        """Delete the reader and the writer of an endpoint, and the topics that no other endpoint uses."""
        for entity in filter(None, (end.reader, end.writer)):
            entity.__del__()
        end.reader = end.writer = None
        used = {key for other in self._ends.values() if other is not end for key in other.topics}
        for key in end.topics:
            if key not in used:
                self._topics.pop(key).__del__()
        end.topics.clear()

    # Outgoing messages

    def publish(self, handle: int, cdr: bytes) -> None:
        """Implement `Link.publish`."""
        self._write(self._ends[handle], cdr)

    def request(self, handle: int, number: int, cdr: bytes) -> None:
        """Implement `Link.request`."""
        end = self._ends[handle]
        self._write(end, cdr[:HEADER] + end.id + number.to_bytes(8, 'little', signed=True) + cdr[HEADER:])

    def reply(self, handle: int, who: bytes, cdr: bytes) -> None:
        """Implement `Link.reply`."""
        self._write(self._ends[handle], cdr[:HEADER] + who + cdr[HEADER:])

    def _write(self, end: End, cdr: bytes) -> None:
        code = 0 if end.writer is None else ddspy_write(reference(end.writer), padded(cdr))
        if code < 0:
            slow = 'a reliable subscriber takes them too slowly'
            why = slow if code == DDSException.DDS_RETCODE_TIMEOUT else str(DDSException(code))
            self._events.append(LinkDiagnostic(f'not sent {end.name} {code}', f'{end.name}: could not send a message: {why}'))
            self._ring()

    def flush(self) -> None:
        """Announce new nodes and endpoints; see `Link.flush`. Messages are sent immediately."""
        if self._is_announced:
            return
        self._is_announced = True
        ends = list(self._ends.values())
        nodes = []
        for handle, (namespace, name) in self._nodes.items():
            own = [end for end in ends if end.node == handle]
            readers = [end.reader.guid.bytes for end in own if end.reader is not None]
            nodes.append((namespace, name, readers, [end.writer.guid.bytes for end in own if end.writer is not None]))
        self._discovery.tell(nodes)

    # Incoming messages; the first three functions run in threads of Cyclone DDS

    def _mark(self, handle: int, end: End) -> None:
        if not end.is_marked:
            end.is_marked = True
            self._marked.append(handle)
            self._ring()

    def _news(self) -> None:
        if not self._has_news:
            self._has_news = True
            self._ring()

    def _ring(self) -> None:
        try:
            self._bell.send(b'.')
        except (BlockingIOError, OSError):
            return  # a wake-up is already pending, or the reader is closed

    def take(self) -> Sequence[Event]:
        """Implement `Link.take`."""
        with suppress(BlockingIOError):
            self._wake_end.recv(4096)
        if self._has_news:
            self._has_news = False
            found, has_more = self._discovery.take()
            if found:
                self._look_at_services()
                self._events.append(GraphChanged())
            if has_more:
                self._news()
        for _ in range(len(self._marked)):
            handle = self._marked.popleft()
            end = self._ends.get(handle)
            if end is not None and end.reader is not None:
                self._take_from(handle, end)
        events = [*self._events, *self._discovery.diagnostics]
        self._events, self._discovery.diagnostics = [], []
        return events

    def _take_from(self, handle: int, end: End) -> None:
        end.is_marked = False
        taken = ddspy_take(reference(end.reader), ANY, AT_ONCE)
        if not isinstance(taken, list):
            return
        for data, info in taken:
            if info.valid_data:
                gid = self._writer_of(end, info.publication_handle)
                event = _event(handle, end, gid, info.source_timestamp, bytes(data))
                self._events += [] if event is None else [event]
        if len(taken) == AT_ONCE:
            self._mark(handle, end)

    def _writer_of(self, end: End, handle: int) -> bytes:
        """Return the gid of the endpoint that sent a sample."""
        gid = end.writers.get(handle)
        if gid is None:
            gid = ddspy_get_matched_publication_data(reference(end.reader), handle, lambda key, *_: key, qos_from)
            if gid is None:
                return b''
            if len(end.writers) > 1000:  # most of these writers are closed
                end.writers.clear()
            end.writers[handle] = gid
        return bytes(gid)

    def graph(self) -> RemoteGraph:
        """Return the remote graph; see `Link.graph`. Services that this link cannot use are left out."""
        remote = self._discovery.graph()
        return remote._replace(
            endpoints=[end for end in remote.endpoints if not (end.kind in (SERVICE, CLIENT) and is_fast_dds(end.gid))]
        )

    def _look_at_services(self) -> None:
        """Announce the services and clients for which a compatible peer exists."""
        self._services.look(self._discovery.graph())
        for handle, end in list(self._ends.items()):
            if end.kind in (SERVICE, CLIENT) and not end.is_on:
                diagnostic = self._services.diagnostic(end.kind, end.name)
                if diagnostic is not None:
                    self._events.append(diagnostic)
                    self._ring()
                if self._services.is_wanted(end.kind, end.name):
                    self._begin(handle, end)

    def fileno(self) -> int:
        """Implement `Link.fileno`."""
        return self._wake_end.fileno()

    def close(self) -> None:
        """Implement `Link.close`."""
        if self._participant is not None:
            self._participant.__del__()  # cyclonedds has no other way to close it; this also closes its entities
            self._participant = None
            leave(self._domain)
        self._ends.clear()
        self._topics.clear()
        self._wake_end.close()
        self._bell.close()


def _event(handle: int, end: End, gid: bytes, source_ns: int, data: bytes) -> Event | None:
    if end.kind == SUBSCRIPTION:
        return Message(handle, gid, source_ns, data)
    if is_fast_dds(gid) or len(data) < HEADER + ID:
        return LinkDiagnostic(
            f'{end.kind} {end.name}', f'{end.name}: dropped a message for this {end.kind}, because it is not from Cyclone DDS'
        )
    who, rest = data[HEADER : HEADER + ID], data[:HEADER] + data[HEADER + ID :]
    if end.kind == SERVICE:
        return Request(handle, who, rest)
    return Response(handle, int.from_bytes(who[8:], 'little', signed=True), rest) if who[:8] == end.id else None
