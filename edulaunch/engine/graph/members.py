"""The members of a graph. `Members` adds and removes nodes and endpoints, and reports each change to the programs that
wait for it.

`graph.py` creates the endpoints. An endpoint depends only on the part of its graph that this file defines.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from edulaunch.engine.graph.node_entry import NodeEntry
from edulaunch.engine.graph.tracer import Tracer
from edulaunch.engine.sim.simulation import Simulation


class Members:
    """Nodes and endpoints of one simulation. `changes` counts the additions and removals.

    :ivar publishers: the publishers by topic name, in order of creation.
    :ivar subscriptions: the subscriptions by topic name, in order of creation.
    :ivar services: the servers by service name, in order of creation.
    :ivar clients: the clients by service name, in order of creation.
    """

    def __init__(self, sim: Simulation, tracer: Tracer | None = None) -> None:
        self.sim = sim
        self.tracer = tracer if tracer is not None else Tracer()
        self.nodes: list[NodeEntry] = []
        self.publishers: dict[str, list[Any]] = {}
        self.subscriptions: dict[str, list[Any]] = {}
        self.services: dict[str, list[Any]] = {}
        self.clients: dict[str, list[Any]] = {}
        self.changes = 0
        self.on_change: list[Callable[[], object]] = []
        self.last_index = 0
        self._tables = {
            'publisher': self.publishers,
            'subscription': self.subscriptions,
            'service': self.services,
            'client': self.clients,
        }

    def next_index(self) -> int:
        """Return the next index. Nodes and endpoints share one sequence of indices, in order of creation."""
        self.last_index += 1
        return self.last_index

    def add_node(self, process: Any, name: str, namespace: str) -> NodeEntry:
        """Add a node, and return it. `namespace` is absolute ('/' for the root)."""
        node = NodeEntry(process, name, namespace, self.next_index())
        self.nodes.append(node)
        self.tracer.node_added(node)
        self._changed()
        return node

    def remove_node(self, node: NodeEntry) -> None:
        """Remove a node with all its endpoints; ignore a node that has been removed already."""
        if node not in self.nodes:
            return
        self.tracer.node_leaving(node)
        for endpoint in list(node.endpoints):
            endpoint.destroy()
        self.nodes.remove(node)
        self.tracer.node_removed(node)
        self._changed()

    def remove_process(self, process: Any) -> None:
        """Remove all nodes of a process, for example when the process has ended."""
        for node in [node for node in self.nodes if node.process is process]:
            self.remove_node(node)

    def add_end(self, node: NodeEntry, table: dict[str, list[Any]], name: str, endpoint: Any) -> None:
        """Add an endpoint of a node.

        :param table: `publishers`, `subscriptions`, `services` or `clients`.
        :param name: the name of the endpoint's topic or service.
        """
        table.setdefault(name, []).append(endpoint)
        node.endpoints.append(endpoint)
        self.tracer.endpoint_added(endpoint.kind, endpoint)
        self._changed()

    def remove_end(self, endpoint: Any) -> None:
        """Remove an endpoint; ignore an endpoint that has been removed already."""
        if endpoint.destroyed:
            return
        endpoint.destroyed = True
        table, name = self._tables[endpoint.kind], endpoint.name
        table[name].remove(endpoint)
        if not table[name]:
            del table[name]
        endpoint.node.endpoints.remove(endpoint)
        self.tracer.endpoint_removed(endpoint.kind, endpoint)
        self._changed()

    def _changed(self) -> None:
        self.changes += 1
        for callback in list(self.on_change):
            callback()
