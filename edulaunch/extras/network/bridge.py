"""Join a machine to a ROS 2 network. The machine's nodes are visible on the network, and real nodes are visible in the
machine.
"""

from __future__ import annotations

import time as wall
from collections import OrderedDict, deque
from collections.abc import Callable
from typing import Any

from edulaunch.engine.graph.node_entry import NodeEntry
from edulaunch.engine.graph.qos import TRANSIENT_LOCAL
from edulaunch.engine.graph.services import ServiceClient
from edulaunch.engine.interfaces.registry import underlay_registry
from edulaunch.errors import InterfaceError
from edulaunch.extras.network.crossing import EVERYTHING, Crossing
from edulaunch.extras.network.diagnostics import LinkDiagnostics
from edulaunch.extras.network.mirror import Mirror
from edulaunch.extras.network.network_link import (
    PUBLISHER,
    SERVICE,
    SUBSCRIPTION,
    GraphChanged,
    Interface,
    Link,
    LinkDiagnostic,
    LinkError,
    Message,
    Request,
    Response,
    Settings,
)
from edulaunch.extras.network.remote import NullQueue, RemotePublisher, is_remote, named
from edulaunch.ros.serialization.cdr import decode, encode
from edulaunch.runtime.session import Session

REMEMBERED = 1000
"""The number of messages that are remembered after they have arrived at one of several subscriptions."""
MOST_EARLY = 5000
"""The maximum number of messages that wait until their sender is known."""
MOST_REQUESTS = 1000
"""The maximum number of requests from the network that wait for one service."""
CLOCKS_DIFFER_NS = 3 * 10**9
"""The smallest difference of clocks that is reported. A machine at its limit is late by less."""


class Bridge:
    """The connection of one machine with one network.

    :param crossing: which topics and services cross, and in which direction.
    :param tell: called with each message for the user.
    :param wall_ns: returns the time of this computer's clock, in nanoseconds.
    """

    def __init__(
        self,
        session: Session,
        link: Link,
        crossing: Crossing = EVERYTHING,
        tell: Callable[[str], object] = print,
        wall_ns: Callable[[], int] = wall.time_ns,
    ) -> None:
        self.session, self.link, self.crossing, self._wall_ns = session, link, crossing, wall_ns
        self.graph = session.graph
        self.diagnostics = LinkDiagnostics(tell, self.note)
        registry = session.host.overlay(session.index).registry
        self.mirror = Mirror(self.graph, registry, crossing, self._ask, self.diagnostics.add)
        self.sent = self.received = 0
        self._is_changed = True
        self._is_open = False
        self._nodes: dict[NodeEntry, int] = {}
        self._handles: dict[int, tuple[Any, int]] = {}
        self._by_handle: dict[int, Any] = {}
        self._askers: dict[int, Asker] = {}
        self._untap: dict[int, Any] = {}
        self._asked: dict[int, int] = {}
        self._recent: OrderedDict[tuple[bytes, int], Any] = OrderedDict()
        self._early: deque[Message] = deque(maxlen=MOST_EARLY)

    def open(self, settings: Settings) -> None:
        """Join the network.

        :raises LinkError: when the link cannot join.
        """
        self.link.open(settings)
        self._is_open = True
        self.graph.on_change.append(self._changed)
        self.after_turn()

    def close(self) -> None:
        """Leave the network. A second call has no effect."""
        if not self._is_open:
            return
        self._is_open = False
        self.graph.on_change.remove(self._changed)
        for end, _ in list(self._handles.values()):
            self._restore(end)
        self.mirror.close()
        self.link.close()

    def _changed(self) -> None:
        self._is_changed = True

    def note(self, key: str) -> None:
        """Record a problem. The key 'clock /node' becomes the kind 'network clock' and the subject '/node'."""
        kind, _, text = key.partition(' ')
        self.session.recorder.note(None, f'network {kind}', text)

    # This machine's nodes on the network

    def after_turn(self) -> None:
        """Send changes of this machine to the network. The machine calls this method after each turn."""
        if self._is_open:
            if self._is_changed:
                self._is_changed = False
                self._show_own()
            self.link.flush()

    def _show_own(self) -> None:
        own = [node for node in self.graph.nodes if not is_remote(node)]
        there = {end.index for node in own for end in node.endpoints}
        for index in [index for index in self._handles if index not in there]:
            self._hide(index)
        alive = set(own)
        for node in [node for node in self._nodes if node not in alive]:
            self.link.remove_node(self._nodes.pop(node))
        for node in own:
            if node not in self._nodes:
                self._nodes[node] = self.link.add_node(node.namespace, node.name)
            for end in list(node.endpoints):
                if end.index not in self._handles:
                    self._show(node, end)
        self.mirror.retype()

    def _show(self, node: NodeEntry, end: Any) -> None:
        name = end.topic_name if end.kind in (PUBLISHER, SUBSCRIPTION) else end.service_name
        if not self.crossing.allows(end.kind, name, True):
            return
        overlay = getattr(node.process, 'overlay', None)
        interface = Interface(end.type_name, underlay_registry() if overlay is None else overlay.registry)
        try:
            handle = self.link.add(self._nodes[node], end.kind, name, interface, end.qos)
        except (LinkError, InterfaceError) as error:
            self.diagnostics.add(LinkDiagnostic(f'{end.kind} {name}', str(error)))
            handle = 0
        self._handles[end.index] = end, handle
        if not handle:
            return
        self._by_handle[handle] = end
        self.mirror.check_hash(end, interface)
        if end.kind == PUBLISHER:
            self._tap(end, handle)
        elif end.kind == SERVICE:
            self._askers[handle] = Asker(self, end, handle)

    def _hide(self, index: int) -> None:
        end, handle = self._handles.pop(index)
        self._untap.pop(index, None)
        if handle:
            del self._by_handle[handle]
            self._askers.pop(handle, None)
            self._asked.pop(handle, None)
            self.link.remove(handle)

    def _tap(self, publisher: Any, handle: int) -> None:
        """Send the messages of a publisher to the network, too, at the moment when each is recorded."""
        record, cls, topic, listeners, publish = (
            publisher.record,
            publisher.cls,
            publisher.topic_name,
            self.mirror.listeners,
            self.link.publish,
        )
        stays = publisher.qos.durability == TRANSIENT_LOCAL

        def recorded(item: Any) -> None:
            record(item)
            if stays or listeners.get(topic):
                self.sent += 1
                publish(handle, encode(cls, item[2]))

        self._untap[publisher.index] = record
        publisher.record = recorded
        for wire, *_ in publisher.history or ():
            self.sent += 1
            publish(handle, encode(cls, wire))

    def _restore(self, end: Any) -> None:
        record = self._untap.pop(end.index, None)
        if record is not None and not end.destroyed:
            end.record = record

    def _ask(self, item: Any) -> None:
        """Send a client's request to the network. As in DDS, all services of that name receive it."""
        wire, (client, number) = item
        if client.index not in self._handles:
            self._show_own()  # the client was created in this turn
        _, handle = self._handles.get(client.index, (None, 0))
        if handle and self._asked.get(handle) != number:
            self._asked[handle] = number
            self.link.request(handle, number, encode(client.cls.Request, wire))

    # Messages from the network

    def take(self) -> None:
        """Pass to the simulation what the link has received: messages, requests, responses, diagnostics and changes of
        the graph."""
        if not self._is_open:
            return
        for event in self.link.take():
            if isinstance(event, Message):
                self._message(event)
            elif isinstance(event, GraphChanged):
                self.mirror.update(self.link.graph())
                early, self._early = self._early, deque(maxlen=MOST_EARLY)
                for message in early:
                    self._message(message)
            elif isinstance(event, LinkDiagnostic):
                self.diagnostics.add(event)
            elif isinstance(event, Request):
                self._request(event)
            else:
                self._response(event)

    def _decoded(self, cls: Any, cdr: bytes, what: str) -> Any:
        """Return the wire tuple for the bytes of a message, or None if the bytes are not of that type."""
        try:
            return decode(cls, cdr)
        except (InterfaceError, MemoryError) as error:
            self.diagnostics.add(LinkDiagnostic(f'bytes {what}', f'{what}: dropped, {error}'))
            return None

    def _message(self, event: Message) -> None:
        subscription = self._by_handle.get(event.handle)
        if subscription is None or subscription.destroyed:
            return
        topic = subscription.topic_name
        publisher = self.mirror.publisher(event.gid, topic)
        if publisher is None and not event.gid:
            self._early.append(event)  # the link may learn the sender later
            return
        key = event.gid, event.source_ns
        several = event.gid and len(self.graph.subscriptions.get(topic, ())) > 1
        wire = self._recent.get(key) if several else None
        is_new = wire is None
        if is_new:
            wire = self._decoded(subscription.cls, event.cdr, topic)
        if wire is None or publisher is None:
            return
        if several and is_new:
            self._recent[key] = wire
            if len(self._recent) > REMEMBERED:
                self._recent.popitem(last=False)
        if len(subscription.queue) == subscription.queue.maxlen:
            self.session.sim.run(self.session.sim.now_ns)  # let the program take messages before the full queue drops the oldest
        if is_new:
            self.received += 1
            publisher.record(wire)
            if abs(event.source_ns - self.session.sim.now_ns) > CLOCKS_DIFFER_NS:
                self._compare_clocks(publisher, event.source_ns)
        subscription.queue.append((wire, self.session.sim.now_ns, publisher, publisher.published))
        subscription.on_ready()

    def _compare_clocks(self, publisher: RemotePublisher, source_ns: int) -> None:
        """Report a computer whose clock differs. A message that was stored for late subscriptions may be old."""
        ahead_ns = source_ns - self._wall_ns()
        if not source_ns or abs(ahead_ns) <= CLOCKS_DIFFER_NS or (ahead_ns < 0 and publisher.qos.durability == TRANSIENT_LOCAL):
            return
        node, seconds = named(publisher.node), abs(ahead_ns) / 10**9
        what = f"the clock of {node} is {seconds:.0f} s ahead of this computer's"
        if ahead_ns < 0:
            what = f'a message of {node} on {publisher.topic_name} is {seconds:.0f} s old: its clock or the network is slow'
        self.diagnostics.add(
            LinkDiagnostic(
                f'clock {node}',
                f'{what}\n  help: synchronise both clocks by NTP; until then, tf finds no transforms between them',
            )
        )

    def _request(self, event: Request) -> None:
        asker = self._askers.get(event.handle)
        if asker is not None:
            wire = self._decoded(asker.cls.Request, event.cdr, asker.service_name)
            if wire is not None:
                self.received += 1
                asker.ask(event.who, wire)

    def _response(self, event: Response) -> None:
        client = self._by_handle.get(event.handle)
        if client is not None:
            wire = self._decoded(client.cls.Response, event.cdr, client.service_name)
            server = next((each for each in client.servers() if is_remote(each.node)), None)
            if wire is not None and server is not None:
                self.received += 1
                server.respond((client, event.number), wire)


class Asker(ServiceClient):
    """Calls a service of this machine for clients on the network. No command lists it as a client."""

    def __init__(self, bridge: Bridge, server: Any, handle: int) -> None:
        super().__init__(bridge.graph, bridge.mirror.unknown(), server.service_name, server.cls, server.qos, self._answered)
        self.queue = NullQueue()  # type: ignore[assignment]
        self._bridge, self._server, self._handle = bridge, server, handle
        self._whos: OrderedDict[int, bytes] = OrderedDict()

    def ask(self, who: bytes, wire: Any) -> None:
        """Pass a request on to the service."""
        self._sequence = number = self._sequence + 1
        self._whos[number] = who
        if len(self._whos) > MOST_REQUESTS:
            oldest, _ = self._whos.popitem(last=False)
            self.unanswered.discard(oldest)
        self.graph.tracer.request(self, number, wire, True)
        self.unanswered.add(number)
        self._server.queue.append((wire, (self, number)))
        self._server.on_ready()

    def _answered(self) -> None:
        number, wire = self.queue.last  # type: ignore[attr-defined]
        who = self._whos.pop(number, None)
        if who is not None and not self._server.destroyed:
            self._bridge.sent += 1
            self._bridge.link.reply(self._handle, who, encode(self.cls.Response, wire))
