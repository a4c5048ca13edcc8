"""Who is there: nodes and their endpoints come and go, and everybody who waits for a change is called.

`graph.py` creates endpoints with these classes; an endpoint knows no more of its graph than this file defines.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from edulaunch.engine.graph.node_entry import NodeEntry
from edulaunch.engine.graph.tracer import Tracer
from edulaunch.engine.sim.simulation import Simulation


class Members:
    """Nodes and endpoints of one simulation. `changes` counts up whenever anything comes or goes.

    :ivar publishers, subscriptions, services, clients: the endpoints by name, in order of creation.
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
        """Return the next number in order of creation, for nodes and endpoints alike."""
        self.last_index += 1
        return self.last_index

    def add_node(self, process: Any, name: str, namespace: str) -> NodeEntry:
        """Let a node join; `namespace` is absolute ('/' for the root)."""
        node = NodeEntry(process, name, namespace, self.next_index())
        self.nodes.append(node)
        self.tracer.node_added(node)
        self._changed()
        return node

    def remove_node(self, node: NodeEntry) -> None:
        """Let a node leave, with all its endpoints; a node that has left already is ignored."""
        if node not in self.nodes:
            return
        self.tracer.node_leaving(node)
        for endpoint in list(node.endpoints):
            endpoint.destroy()
        self.nodes.remove(node)
        self.tracer.node_removed(node)
        self._changed()

    def remove_process(self, process: Any) -> None:
        """Let all nodes of a process leave, as when the process has ended."""
        for node in [node for node in self.nodes if node.process is process]:
            self.remove_node(node)

    def add_end(self, node: NodeEntry, table: dict[str, list[Any]], name: str, endpoint: Any) -> None:
        """Let an endpoint of a node join.

        :param table: `publishers`, `subscriptions`, `services` or `clients`.
        :param name: of its topic or service.
        """
        table.setdefault(name, []).append(endpoint)
        node.endpoints.append(endpoint)
        self.tracer.endpoint_added(endpoint.kind, endpoint)
        self._changed()

    def remove_end(self, endpoint: Any) -> None:
        """Let an endpoint leave; one that has left already is ignored."""
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
