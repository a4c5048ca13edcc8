"""The interface of links, which carry a machine's messages to a ROS 2 network and back. The bridge uses only this interface.

A link identifies its nodes and endpoints by numbers. Messages are CDR bytes with their 4-byte header. Remote endpoints
have 16-byte gids. Topic and service names are fully expanded ROS names ('/turtle1/pose'), which the link converts.
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
"""The prefix of the names of a link's internal nodes. They are hidden, and edulaunch never shows them."""
ENCLAVE = f'/{MARK}'
"""The enclave of a machine's participant, by which machines recognise each other. Only SROS 2 uses enclaves."""
PUBLISHER, SUBSCRIPTION, SERVICE, CLIENT = 'publisher', 'subscription', 'service', 'client'
"""The kinds of endpoints, with the same names as in `graph`."""
KEPT = 1000
"""The minimum number of messages that a reliable publisher on this computer stores until all have arrived. A subscriber on a busy
computer may not run for a while, such as 5 s at 200 messages per second. DDS does not announce this number.
"""
WAITING = 1000
"""The number of messages that may wait for their subscription, unless its depth is larger. Other nodes cannot see this number."""


class Interface:
    """The type of an endpoint.

    :ivar name: the name of the type, such as 'geometry_msgs/msg/Twist' or 'turtlesim/srv/Spawn'.
    :ivar registry: holds the definition, the spec and the class of the type and of its nested types.
    """

    def __init__(self, name: str, registry: Registry) -> None:
        self.name = name
        self.registry = registry

    @cached_property
    def hash(self) -> str:
        """Return the type hash, 'RIHS01_...'."""
        from edulaunch.ros.serialization.type_description import type_hash

        return type_hash(self.name, self.registry.spec)


class Settings(NamedTuple):
    """The settings of a join: ROS_DOMAIN_ID, ROS_AUTOMATIC_DISCOVERY_RANGE and ROS_STATIC_PEERS.

    :ivar discovery_range: 'LOCALHOST' (also the default), 'SUBNET' or 'OFF'.
    """

    domain: int = 0
    discovery_range: str = 'LOCALHOST'
    static_peers: tuple[str, ...] = ()


class RemoteNode(NamedTuple):
    """A node of the network that does not belong to this machine.

    :ivar participant: the gid of the node's participant.
    :ivar is_simulated: whether the node is known to belong to another simulated machine.
    """

    participant: bytes
    namespace: str
    name: str
    is_simulated: bool = False


class RemoteEndpoint(NamedTuple):
    """An endpoint of the network that does not belong to this machine.

    :ivar gid: the identifier of the endpoint. For a service, it is the gid of the reader of requests. For a client, it is the gid
        of the writer of requests.
    :ivar hash: the hash of the endpoint's type, or '' if the endpoint announces no hash.
    :ivar node: the node of the endpoint; None if no node has claimed the endpoint (yet), or its program does not use ROS 2.
    """

    gid: bytes
    kind: str
    name: str
    type_name: str
    hash: str
    qos: QoS
    node: RemoteNode | None


class RemoteGraph(NamedTuple):
    """The other nodes and endpoints on the network, without the nodes and endpoints of this link. If an endpoint has not
    changed, its object is the same as before.
    """

    nodes: Sequence[RemoteNode]
    endpoints: Sequence[RemoteEndpoint]


class Message(NamedTuple):
    """A message for a subscription.

    :ivar gid: the gid of the publisher; b'' if the link does not report it.
    :ivar source_ns: when the message was sent, by the sender's clock. With the gid, it shows whether two subscriptions received
        the same message.
    """

    handle: int
    gid: bytes
    source_ns: int
    cdr: bytes


class Request(NamedTuple):
    """A request for a service. `who` is returned with the reply."""

    handle: int
    who: bytes
    cdr: bytes


class Response(NamedTuple):
    """A reply for a client, with the number that the client gave to its request."""

    handle: int
    number: int
    cdr: bytes


class GraphChanged(NamedTuple):
    """The result of :meth:`Link.graph` has changed."""


class LinkDiagnostic(NamedTuple):
    """A message for the user about dropped data, or about a limit of this link.

    :ivar key: identifies the diagnostic. Diagnostics with equal keys are reported once, and counted.
    :ivar about: the name in `text` to which the diagnostic refers. Diagnostics that differ only in that name become one line of a
        status.
    """

    key: str
    text: str
    about: str = ''


Event = Message | Request | Response | GraphChanged | LinkDiagnostic


class LinkError(EdulaunchError):
    """A link could not be opened, or could not create an endpoint."""


class Link(Protocol):
    """A connection to a ROS 2 network. No method blocks for longer than about a millisecond, except `open` and `close`.

    One thread calls all methods. A link stores a limited number of incoming messages until `take`, and makes `fileno` readable.

    :ivar title: the name of the link for `edulaunch network status`, such as 'cyclonedds 11.0.1'.
    """

    title: str

    def open(self, settings: Settings) -> None:
        """Join the network.

        :raises LinkError: when the link cannot join. The message names a missing program and how to install it.
        """

    def add_node(self, namespace: str, name: str) -> int:
        """Announce a node of this machine."""

    def remove_node(self, handle: int) -> None:
        """Withdraw a node whose endpoints were removed before."""

    def add(self, node: int, kind: str, name: str, interface: Interface, qos: QoS) -> int:
        """Announce an endpoint of this machine, and match it with remote endpoints.

        :raises LinkError: when the link does not support the endpoint.
        """

    def remove(self, handle: int) -> None:
        """Withdraw an endpoint."""

    def publish(self, handle: int, cdr: bytes) -> None:
        """Send a message from a publisher. A transient-local publisher stores it for late subscriptions, as its QoS requires."""

    def request(self, handle: int, number: int, cdr: bytes) -> None:
        """Send a request from a client."""

    def reply(self, handle: int, who: bytes, cdr: bytes) -> None:
        """Send a service's reply to a :class:`Request`."""

    def flush(self) -> None:
        """Send everything that waits. The bridge calls this method after each turn of the machine with new messages or
        endpoints.
        """

    def take(self) -> Sequence[Event]:
        """Return the incoming messages since the last call, without the messages of this link. The number of messages is
        limited. If more messages wait, `fileno` stays readable.
        """
        ...

    def graph(self) -> RemoteGraph:
        """Return the other nodes and endpoints that exist now."""
        ...

    def fileno(self) -> int:
        """Return the file descriptor to wait for with `select`. It is readable when `take` has messages."""
        ...

    def close(self) -> None:
        """Leave the network immediately, in any state. A second call has no effect."""
