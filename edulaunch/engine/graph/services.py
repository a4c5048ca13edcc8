"""Services. The service name connects a request with its servers, and the request number connects a reply with its
request.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from edulaunch.engine.graph.qos import QoS

if TYPE_CHECKING:
    from edulaunch.engine.graph.members import Members
    from edulaunch.engine.graph.node_entry import NodeEntry

RequestId = tuple['ServiceClient', int]
"""The client of a request, and the client's number for it."""


class ServiceEnd:
    """The common base of servers and clients. `cls` is the service class, with `Request` and `Response`."""

    kind = 'service end'

    def __init__(
        self, graph: Members, node: NodeEntry, service_name: str, cls: Any, qos: QoS, on_ready: Callable[[], object]
    ) -> None:
        self.graph = graph
        self.node = node
        self.service_name = service_name
        self.cls = cls
        self.type_name: str = cls.TYPE
        self.qos = qos
        self.on_ready = on_ready
        self.index = graph.next_index()
        self.destroyed = False

    @property
    def name(self) -> str:
        """The name of the service."""
        return self.service_name


class ServiceServer(ServiceEnd):
    """One server of a service; `queue` contains the waiting requests, oldest first."""

    kind = 'service'

    def __init__(
        self, graph: Members, node: NodeEntry, service_name: str, cls: Any, qos: QoS, on_ready: Callable[[], object]
    ) -> None:
        super().__init__(graph, node, service_name, cls, qos, on_ready)
        self.queue: deque[tuple[Any, RequestId]] = deque(maxlen=qos.queue_length)

    def take(self) -> tuple[Any, RequestId] | None:
        """Return the oldest waiting request as (wire, request id), or None if no request is waiting."""
        return self.queue.popleft() if self.queue else None

    def respond(self, request_id: RequestId, wire: Any) -> None:
        """Send the reply to the client. Do nothing if the client no longer exists or already has a reply."""
        client, sequence = request_id
        if client.destroyed or sequence not in client.unanswered:
            return
        client.unanswered.remove(sequence)
        self.graph.tracer.response(client, sequence, wire)
        client.queue.append((sequence, wire))
        client.on_ready()

    def destroy(self) -> None:
        """Remove the server from the service. Requests that are still waiting never get a reply."""
        self.graph.remove_end(self)


class ServiceClient(ServiceEnd):
    """One client of a service; `queue` contains the replies as (sequence, wire), oldest first.

    :ivar lost: the number of requests for which there was no server.
    :ivar unanswered: the numbers of the requests that wait for a reply.
    """

    kind = 'client'

    def __init__(
        self, graph: Members, node: NodeEntry, service_name: str, cls: Any, qos: QoS, on_ready: Callable[[], object]
    ) -> None:
        super().__init__(graph, node, service_name, cls, qos, on_ready)
        self.queue: deque[tuple[int, Any]] = deque()
        self.lost = 0
        self.unanswered: set[int] = set()
        self._sequence = 0

    def server_is_ready(self) -> bool:
        """Return whether a server with the name and type of this client exists now."""
        return bool(self.servers())

    def servers(self) -> list[ServiceServer]:
        """Return the servers that would get a request now, in order of creation."""
        return [server for server in self.graph.services.get(self.service_name, ()) if server.type_name == self.type_name]

    def send(self, wire: Any) -> int:
        """Send a request to all servers of the service, and return the number of the request.

        The client receives only the first reply. Without a server, the request is lost, as in ROS 2.
        """
        self._sequence = sequence = self._sequence + 1
        servers = self.servers()
        # record the request first, because built-in servers answer immediately
        self.graph.tracer.request(self, sequence, wire, bool(servers))
        if servers:
            self.unanswered.add(sequence)
        else:
            self.lost += 1
        for server in servers:
            server.queue.append((wire, (self, sequence)))
            server.on_ready()
        return sequence

    def take(self) -> tuple[int, Any] | None:
        """Return the oldest waiting reply as (sequence, wire), or None if no reply is waiting."""
        return self.queue.popleft() if self.queue else None

    def destroy(self) -> None:
        """Remove the client from the service. Later replies are dropped."""
        self.graph.remove_end(self)
