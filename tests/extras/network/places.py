"""Machines, and a network without any wire between them."""

from __future__ import annotations

import os
from collections.abc import Sequence
from types import SimpleNamespace
from typing import Any

from edulaunch.engine.graph.qos import QoS
from edulaunch.engine.interfaces.registry import underlay_registry
from edulaunch.engine.sim.pacing import RealTime
from edulaunch.extras.network.bridge import Bridge
from edulaunch.extras.network.network_link import (
    CLIENT,
    PUBLISHER,
    SERVICE,
    SUBSCRIPTION,
    Event,
    GraphChanged,
    Interface,
    Message,
    RemoteEndpoint,
    RemoteGraph,
    RemoteNode,
    Request,
    Response,
    Settings,
)
from edulaunch.ros.serialization.cdr import decode, encode
from edulaunch.runtime.session import Session

STRING = 'std_msgs/msg/String'
TRIGGER = 'std_srvs/srv/Trigger'


def cls_of(type_name: str) -> Any:
    return underlay_registry().get(type_name)


def text(words: str) -> bytes:
    """The CDR bytes of a String."""
    return encode(cls_of(STRING), (words,))


def words_in(cdr: bytes) -> str:
    return str(decode(cls_of(STRING), cdr)[0])


class Air:
    """What all memory links are on."""

    def __init__(self) -> None:
        self.links: list[MemoryLink] = []
        self.now = 0

    def changed(self, by: MemoryLink) -> None:
        for link in self.links:
            if link is not by:
                link.events.append(GraphChanged())


class MemoryLink:
    """A link as `network_link.Link` has it: what one says stands at the others' when the call returns."""

    title = 'memory'

    def __init__(self, air: Air) -> None:
        self.air = air
        self.events: list[Event] = []
        self.nodes: dict[int, RemoteNode] = {}
        self.ends: dict[int, RemoteEndpoint] = {}
        self.published: list[bytes] = []
        self.gid = os.urandom(16)
        self._count = 0

    def open(self, settings: Settings) -> None:
        self.air.links.append(self)
        self.events.append(GraphChanged())

    def _next(self) -> int:
        self._count += 1
        self.air.changed(self)
        return self._count

    def add_node(self, namespace: str, name: str) -> int:
        handle = self._next()
        self.nodes[handle] = RemoteNode(self.gid, namespace, name)
        return handle

    def remove_node(self, handle: int) -> None:
        del self.nodes[handle]
        self.air.changed(self)

    def add(self, node: int, kind: str, name: str, interface: Interface, qos: QoS) -> int:
        handle = self._next()
        gid = self.gid[:12] + handle.to_bytes(4, 'big')
        self.ends[handle] = RemoteEndpoint(gid, kind, name, interface.name, interface.hash, qos, self.nodes[node])
        return handle

    def remove(self, handle: int) -> None:
        del self.ends[handle]
        self.air.changed(self)

    def _reach(self, kind: str, name: str) -> list[tuple[MemoryLink, int]]:
        others = [link for link in self.air.links if link is not self]
        return [(link, handle) for link in others for handle, end in link.ends.items() if (end.kind, end.name) == (kind, name)]

    def publish(self, handle: int, cdr: bytes) -> None:
        self.published.append(cdr)
        self.air.now += 1
        for link, there in self._reach(SUBSCRIPTION, self.ends[handle].name):
            link.events.append(Message(there, self.ends[handle].gid, self.air.now, cdr))

    def request(self, handle: int, number: int, cdr: bytes) -> None:
        who = self.ends[handle].gid + handle.to_bytes(4, 'big') + number.to_bytes(8, 'big')
        for link, there in self._reach(SERVICE, self.ends[handle].name):
            link.events.append(Request(there, who, cdr))

    def reply(self, handle: int, who: bytes, cdr: bytes) -> None:
        for link, there in self._reach(CLIENT, self.ends[handle].name):
            if link.ends[there].gid == who[:16]:
                link.events.append(Response(there, int.from_bytes(who[20:], 'big'), cdr))

    def flush(self) -> None:
        """All is said."""

    def take(self) -> Sequence[Event]:
        events, self.events = self.events, []
        return events

    def graph(self) -> RemoteGraph:
        others = [link for link in self.air.links if link is not self]
        return RemoteGraph(
            [node for link in others for node in link.nodes.values()], [end for link in others for end in link.ends.values()]
        )

    def fileno(self) -> int:
        return -1

    def close(self) -> None:
        if self in self.air.links:
            self.air.links.remove(self)
            self.air.changed(self)


class Place:
    """One machine with a bridge, and one node on it whose ends log what they hear."""

    def __init__(self, link: Any, settings: Settings = Settings(), name: str = 'node', **options: Any) -> None:
        self.session = Session()
        self.graph, self.sim = self.session.graph, self.session.sim
        self.time = RealTime(self.sim)
        self.said: list[str] = []
        self.link = link
        self.node = self.graph.add_node(SimpleNamespace(name=name, pid=1, state={}), name, '/')
        options.setdefault('wall_ns', lambda: 0)  # a memory link counts instead of telling the time
        self.bridge = Bridge(self.session, link, tell=self.said.append, **options)
        self.heard: list[Any] = []
        self.asked: list[Any] = []
        self.bridge.open(settings)

    def turn(self) -> None:
        """What the machine does again and again."""
        self.bridge.take()
        self.sim.run(self.sim.now_ns)
        self.bridge.after_turn()

    def publisher(self, topic: str, type_name: str = STRING, qos: QoS = QoS()) -> Any:
        return self.graph.create_publisher(self.node, topic, cls_of(type_name), qos)

    def subscription(self, topic: str, type_name: str = STRING, qos: QoS = QoS()) -> Any:
        def ready() -> None:
            if made:
                while (taken := made[0].take()) is not None:
                    self.heard.append(taken[0])

        made: list[Any] = []
        made.append(self.graph.create_subscription(self.node, topic, cls_of(type_name), qos, ready))
        ready()
        return made[0]

    def service(self, name: str, answer: Any = (True, 'done')) -> Any:
        def ready() -> None:
            while (taken := made[0].take()) is not None:
                self.asked.append(taken[0])
                made[0].respond(taken[1], answer)

        made = [self.graph.create_service(self.node, name, cls_of(TRIGGER), QoS(), ready)]
        return made[0]

    def client(self, name: str) -> Any:
        return self.graph.create_client(self.node, name, cls_of(TRIGGER), QoS(), lambda: None)

    def nodes(self) -> list[str]:
        return [node.fully_qualified_name for node in self.graph.nodes]

    def close(self) -> None:
        self.bridge.close()
        self.session.close()


def turns(*places: Place, count: int = 6) -> None:
    """Let all of them go on until they have nothing more to say."""
    for _ in range(count):
        for place in places:
            place.turn()


__all__ = ['PUBLISHER', 'Air', 'MemoryLink', 'Place', 'cls_of', 'text', 'turns', 'words_in']
