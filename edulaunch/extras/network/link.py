"""What carries a machine's messages to a ROS 2 network and back. The bridge knows only this; who implements it is a plug-in.

A link knows nodes and endpoints by numbers that it gives out, messages as CDR bytes with their 4-byte header, and what is far
away by 16-byte gids. Topic and service names are fully expanded ROS names ('/turtle1/pose'); mangling them is the link's work.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property
from typing import TYPE_CHECKING, NamedTuple, Protocol

from edulaunch.errors import EdulaunchError

if TYPE_CHECKING:
    from edulaunch.engine.graph.qos import QoS
    from edulaunch.engine.interfaces.registry import Registry

MARK = '_edulaunch_link'
"""How nodes begin that a link has for itself: hidden, as all names with _ in front, and shown by none of them."""
ENCLAVE = f'/{MARK}'
"""The enclave of a machine's participant, by which machines know each other. It means something to SROS 2 alone."""
PUBLISHER, SUBSCRIPTION, SERVICE, CLIENT = 'publisher', 'subscription', 'service', 'client'
"""The kinds of endpoints; the words of `graph` for the same."""


class Interface:
    """What an endpoint carries.

    :ivar name: 'geometry_msgs/msg/Twist', 'turtlesim/srv/Spawn'.
    :ivar registry: where its text, its spec and its class (and those of nested types) are found.
    """

    def __init__(self, name: str, registry: Registry) -> None:
        self.name = name
        self.registry = registry

    @cached_property
    def hash(self) -> str:
        """The type hash, 'RIHS01_...'."""
        from edulaunch.ros.serialization.type_description import type_hash

        return type_hash(self.name, self.registry.spec)


class Settings(NamedTuple):
    """How to join: ROS_DOMAIN_ID, ROS_AUTOMATIC_DISCOVERY_RANGE and ROS_STATIC_PEERS.

    :ivar discovery_range: 'LOCALHOST' (also what is meant when the variable is not set), 'SUBNET' or 'OFF'.
    """

    domain: int = 0
    discovery_range: str = 'LOCALHOST'
    static_peers: tuple[str, ...] = ()


class RemoteNode(NamedTuple):
    """A node of the network that is not ours.

    :ivar participant: the gid of its participant.
    :ivar is_simulated: whether it is known to be one of another machine like this.
    """

    participant: bytes
    namespace: str
    name: str
    is_simulated: bool = False


class RemoteEndpoint(NamedTuple):
    """An endpoint of the network that is not ours.

    :ivar gid: its number; for a service that of what hears its requests, for a client of what sends them.
    :ivar hash: its type's, '' when it tells none.
    :ivar node: None for one that no node has claimed (yet), and for programs that are no ROS 2.
    """

    gid: bytes
    kind: str
    name: str
    type_name: str
    hash: str
    qos: QoS
    node: RemoteNode | None


class RemoteGraph(NamedTuple):
    """Who else is on the network: nothing of what this link itself has made. An unchanged endpoint is the same object again."""

    nodes: Sequence[RemoteNode]
    endpoints: Sequence[RemoteEndpoint]


class Message(NamedTuple):
    """A message came to a subscription.

    :ivar gid: of its publisher; b'' when the link cannot tell.
    :ivar source_ns: when it was sent, by the sender's clock; with the gid it tells whether two subscriptions got the same one.
    """

    handle: int
    gid: bytes
    source_ns: int
    cdr: bytes


class Request(NamedTuple):
    """A request came to a service; `who` is given back with the reply."""

    handle: int
    who: bytes
    cdr: bytes


class Response(NamedTuple):
    """A reply came to a client, with the number that it gave its request."""

    handle: int
    number: int
    cdr: bytes


class GraphChanged(NamedTuple):
    """:meth:`Link.graph` has news."""


class LinkDiagnostic(NamedTuple):
    """Something that the user has to know: what was dropped, or what this link cannot do.

    :ivar key: the same diagnostic has the same key; it is told once, and counted.
    :ivar about: the name in `text` that it is about: diagnostics that differ in that name alone are one line of a status.
    """

    key: str
    text: str
    about: str = ''


Event = Message | Request | Response | GraphChanged | LinkDiagnostic


class LinkError(EdulaunchError):
    """The link cannot be opened, or not make an endpoint."""


class Link(Protocol):
    """One way onto a ROS 2 network. No method blocks for longer than a millisecond or so, but `open` and `close`.

    All are called by one thread. What a link hears it keeps (bounded) until `take`, and makes `fileno` readable.

    :ivar title: what it is, for `edulaunch network status`: 'cyclonedds 11.0.1'.
    """

    title: str

    def open(self, settings: Settings) -> None:
        """Join the network.

        :raises LinkError: with what is missing and how to get it.
        """

    def add_node(self, namespace: str, name: str) -> int:
        """Let a node of ours be seen."""

    def remove_node(self, handle: int) -> None:
        """It has left; its endpoints were removed before."""

    def add(self, node: int, kind: str, name: str, interface: Interface, qos: QoS) -> int:
        """Let an endpoint of ours be seen, and matched.

        :raises LinkError: when the link cannot carry it.
        """

    def remove(self, handle: int) -> None:
        """It has left."""

    def publish(self, handle: int, cdr: bytes) -> None:
        """Send a message from a publisher. A transient-local one keeps it for who comes later, as its QoS says."""

    def request(self, handle: int, number: int, cdr: bytes) -> None:
        """Send a request from a client."""

    def reply(self, handle: int, who: bytes, cdr: bytes) -> None:
        """Send a service's reply to a :class:`Request`."""

    def flush(self) -> None:
        """Called after each turn of the machine in which something was said or made: let it go out now."""

    def take(self) -> Sequence[Event]:
        """What has come since; never an echo of what this link sent. Bounded: when more waits, `fileno` stays readable."""
        ...

    def graph(self) -> RemoteGraph:
        """Who else is there now."""
        ...

    def fileno(self) -> int:
        """What to wait for with `select`: readable when `take` has something."""
        ...

    def close(self) -> None:
        """Leave the network, at once and whatever state it is in. Doing it twice is doing it once."""
