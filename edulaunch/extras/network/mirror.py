"""Keep the machine's graph equal to the network's graph. An entry in the machine represents each node and endpoint of the
network.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from edulaunch.engine.graph.graph import Graph
from edulaunch.engine.graph.names import namespace_problem, node_name_problem, topic_name_problem
from edulaunch.engine.graph.node_entry import NodeEntry
from edulaunch.engine.interfaces.registry import Registry
from edulaunch.errors import InterfaceError
from edulaunch.extras.network.crossing import Crossing
from edulaunch.extras.network.network_link import (
    PUBLISHER,
    SERVICE,
    SUBSCRIPTION,
    Interface,
    LinkDiagnostic,
    RemoteEndpoint,
    RemoteGraph,
    RemoteNode,
)
from edulaunch.extras.network.remote import (
    UNKNOWN_NAME,
    UNKNOWN_NAMESPACE,
    Network,
    RemoteClient,
    RemotePublisher,
    RemoteService,
    RemoteSubscription,
    TypeName,
    is_remote,
    join,
)

CLAIMED_WITHIN_NS = 10**9
"""An unclaimed endpoint is listed without a node after this time. Most nodes claim their endpoints a little later."""


class Mirror:
    """The remote nodes and endpoints of one graph.

    :param registry: the registry of types.
    :param crossing: which topics and services cross, and in which direction.
    :param ask: passes requests on to a service on the network.
    :param diagnostic: called with each problem.
    """

    def __init__(
        self,
        graph: Graph,
        registry: Registry,
        crossing: Crossing,
        ask: Callable[[Any], object],
        diagnostic: Callable[[LinkDiagnostic], object],
    ) -> None:
        self.graph, self.registry, self.crossing, self.ask, self.diagnostic = graph, registry, crossing, ask, diagnostic
        self.network = Network()
        self.listeners: dict[str, int] = {}
        """The number of real subscriptions of each topic."""
        self._nodes: dict[RemoteNode, NodeEntry] = {}
        self._ends: dict[bytes, tuple[RemoteEndpoint, Any]] = {}
        self._unclaimed: dict[bytes, int] = {}
        self._remote = RemoteGraph((), ())
        self._unknown: NodeEntry | None = None

    def update(self, remote: RemoteGraph) -> None:
        """Set the current nodes and endpoints of the network."""
        self._remote = remote
        known = {end.gid: end for end in remote.endpoints if self._crosses(end)}
        for gid, (end, mirrored) in list(self._ends.items()):
            if known.get(gid) != end:
                self._remove(gid, end, mirrored)
        self._update_nodes(dict.fromkeys(remote.nodes))
        for gid, end in known.items():
            if gid not in self._ends and self._is_due(end):
                self._add(end)
        self._unclaimed = {gid: since for gid, since in self._unclaimed.items() if gid in known and gid not in self._ends}

    def again(self) -> None:
        """Examine the same nodes and endpoints again, because types have arrived or time has passed."""
        self.update(self._remote)

    def publisher(self, gid: bytes, topic: str) -> RemotePublisher | None:
        """Return the publisher that sent a message. If the link does not report the sender, return a possible sender. Return
        None if there is no sender.
        """
        found = self._ends.get(gid)
        if found is None and gid:
            end = next((end for end in self._remote.endpoints if end.gid == gid), None)
            if end is not None and self._crosses(end):
                self._add(end)
                found = self._ends.get(gid)
        if found is not None:
            return found[1] if isinstance(found[1], RemotePublisher) else None
        others = self.graph.publishers.get(topic, ())
        return next((other for other in others if isinstance(other, RemotePublisher)), None)

    def unknown(self) -> NodeEntry:
        """Return the node that represents the unknown owner of endpoints."""
        if self._unknown is None:
            index = self.graph.next_index()
            self._unknown = NodeEntry(self.network, UNKNOWN_NAME, UNKNOWN_NAMESPACE, index)
            self.graph.tracer.node_added(self._unknown)
        return self._unknown

    def retype(self) -> None:
        """Create endpoints again whose types were unknown and may now be known."""
        for gid, (end, mirrored) in list(self._ends.items()):
            if isinstance(mirrored.cls, TypeName) and not isinstance(self._class(end.type_name), TypeName):
                self._remove(gid, end, mirrored)
        self.again()

    def close(self) -> None:
        """Remove all nodes and endpoints of the network."""
        self.update(RemoteGraph((), ()))
        if self._unknown is not None:
            self.graph.tracer.node_removed(self._unknown)

    def _crosses(self, end: RemoteEndpoint) -> bool:
        return self.crossing.allows(end.kind, end.name, False)

    def _is_due(self, end: RemoteEndpoint) -> bool:
        if end.node is not None:
            return True
        now = self.graph.sim.now_ns
        if end.gid not in self._unclaimed:
            self._unclaimed[end.gid] = now
            self.graph.sim.schedule(now + CLAIMED_WITHIN_NS, self.again)
        return now >= self._unclaimed[end.gid] + CLAIMED_WITHIN_NS

    def _update_nodes(self, wanted: dict[RemoteNode, None]) -> None:
        for node in [node for node in self._nodes if node not in wanted]:
            self.graph.remove_node(self._nodes.pop(node))
        for node in wanted:
            if node not in self._nodes:
                if namespace_problem(node.namespace) or node_name_problem(node.name):
                    self.diagnostic(
                        LinkDiagnostic(
                            'node names', f'a node is not shown, because its name {node.namespace!r} {node.name!r} is invalid'
                        )
                    )
                    continue
                entry = self._nodes[node] = self.graph.add_node(self.network, node.name, node.namespace)
                name = entry.fully_qualified_name
                if any(other.fully_qualified_name == name and not is_remote(other) for other in self.graph.nodes):
                    other_one = 'one of another machine' if node.is_simulated else 'a real one'
                    text = f'two nodes have the name {name}: one of this machine, and {other_one}'
                    self.diagnostic(
                        LinkDiagnostic(f'name {name}', f'{text}\n  help: put one of them in a namespace, or rename it')
                    )

    def _add(self, end: RemoteEndpoint) -> None:
        if topic_name_problem(end.name):
            self.diagnostic(LinkDiagnostic('names', f'an endpoint is not shown, because its name {end.name!r} is invalid'))
            return
        node = self._nodes.get(end.node) if end.node is not None else None
        mirrored = self._made(end, node or self.unknown(), self._class(end.type_name))
        self._ends[end.gid] = end, mirrored
        if end.kind == SUBSCRIPTION:
            self.listeners[end.name] = self.listeners.get(end.name, 0) + 1
        join(mirrored)

    def _made(self, end: RemoteEndpoint, node: NodeEntry, cls: Any) -> Any:
        if end.kind == PUBLISHER:
            return RemotePublisher(self.graph, node, end.name, cls, end.qos)
        if end.kind == SUBSCRIPTION:
            return RemoteSubscription(self.graph, node, end.name, cls, end.qos)
        if end.kind == SERVICE:
            return RemoteService(self.graph, node, end.name, cls, end.qos, self.ask)
        return RemoteClient(self.graph, node, end.name, cls, end.qos)

    def _remove(self, gid: bytes, end: RemoteEndpoint, mirrored: Any) -> None:
        del self._ends[gid]
        if end.kind == SUBSCRIPTION:
            self.listeners[end.name] -= 1
            if not self.listeners[end.name]:
                del self.listeners[end.name]
        mirrored.destroy()

    def _class(self, type_name: str) -> Any:
        """Return the class of a type from this machine, or else from a program that uses it. For an unknown type, return a
        placeholder.
        """
        for node in self.graph.nodes:
            for own in () if is_remote(node) else node.endpoints:
                if own.type_name == type_name:
                    return own.cls
        try:
            return self.registry.get(type_name)
        except InterfaceError:
            return TypeName(type_name)

    def check_hash(self, own: Any, interface: Interface) -> None:
        """Report a real endpoint whose type has another definition."""
        name = own.topic_name if own.kind in (PUBLISHER, SUBSCRIPTION) else own.service_name
        for end, _ in self._ends.values():
            if end.name == name and end.type_name == own.type_name and end.hash not in ('', interface.hash):
                text = f'{name}: {end.type_name} has another definition on the network than here, so messages are misread'
                self.diagnostic(LinkDiagnostic(f'hash {end.type_name}', text))
