"""The methods of a node that query the graph."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from edulaunch.engine.facts import with_facts
from edulaunch.engine.graph.names import fully_qualified_name, namespace_problem, node_name_problem, topic_name_problem
from edulaunch.engine.nearest import nearest
from edulaunch.engine.sim.task import current_task
from rclpy._rclpy_pybind11 import NodeNameNonExistentError, RCLError
from rclpy.node_parts.core import NodeCore
from rclpy.node_parts.dds_names import DISCOVERY, READS, WRITES, Directions, NamesAndTypes, dds_names_and_types

if TYPE_CHECKING:
    from edulaunch.engine.graph.graph import Graph
    from rclpy.topic_endpoint_info import TopicEndpointInfo


class NodeGraphQueries:
    """The part of `Node` that queries other nodes, topics and services. Returned names are fully qualified and sorted."""

    _rclpy: NodeCore

    def get_topic_names_and_types(self, no_demangle: bool = False) -> NamesAndTypes:
        """Return all topics with their types. With `no_demangle`, return the DDS names, including the names for services."""
        graph = _looked_at(self._rclpy, 'failed to get topic names and types')
        if no_demangle:
            ends = (graph.publishers, graph.subscriptions, graph.services, graph.clients)
            return [DISCOVERY, *dds_names_and_types([end for table in ends for end in _all(table)], WRITES | READS)]
        return names_and_types([*_all(graph.publishers), *_all(graph.subscriptions)], 'topic_name')

    def get_service_names_and_types(self) -> NamesAndTypes:
        """Return all services that have a server, with their types."""
        return names_and_types(_all(_looked_at(self._rclpy, 'failed to get service names and types').services), 'service_name')

    def get_publisher_names_and_types_by_node(
        self, node_name: str, node_namespace: str, no_demangle: bool = False
    ) -> NamesAndTypes:
        """Return the topics that a node publishes, with their types. With `no_demangle`, return the DDS names.

        :raises NodeNameNonExistentError: for an unknown node.
        """
        return _topics_by_node(self._rclpy, node_name, node_namespace, 'publisher', WRITES if no_demangle else None)

    def get_subscriber_names_and_types_by_node(
        self, node_name: str, node_namespace: str, no_demangle: bool = False
    ) -> NamesAndTypes:
        """Return the topics to which a node subscribes, with their types. With `no_demangle`, return the DDS names.

        :raises NodeNameNonExistentError: for an unknown node.
        """
        return _topics_by_node(self._rclpy, node_name, node_namespace, 'subscription', READS if no_demangle else None)

    def get_service_names_and_types_by_node(self, node_name: str, node_namespace: str) -> NamesAndTypes:
        """Return the services that a node offers, with their types. Raise NodeNameNonExistentError for an unknown node."""
        return _by_node(self._rclpy, node_name, node_namespace, 'service', 'service_name')

    def get_client_names_and_types_by_node(self, node_name: str, node_namespace: str) -> NamesAndTypes:
        """Return the services for which a node has clients, with their types. Raise NodeNameNonExistentError for an unknown
        node.
        """
        return _by_node(self._rclpy, node_name, node_namespace, 'client', 'service_name')

    def get_node_names(self) -> list[str]:
        """Return the names of all nodes without namespaces, in order of creation."""
        return [node.name for node in _looked_at(self._rclpy, _NODE_NAMES).nodes]

    def get_fully_qualified_node_names(self) -> list[str]:
        """Return the fully qualified names of all nodes."""
        return [node.fully_qualified_name for node in _looked_at(self._rclpy, _NODE_NAMES).nodes]

    def get_node_names_and_namespaces(self) -> list[tuple[str, str]]:
        """Return (name, namespace) for each node."""
        return [(node.name, node.namespace) for node in _looked_at(self._rclpy, _NODE_NAMES).nodes]

    def get_node_names_and_namespaces_with_enclaves(self) -> list[tuple[str, str, str]]:
        """Return (name, namespace, enclave) for each node. The enclave is always '/'."""
        return [(node.name, node.namespace, '/') for node in _looked_at(self._rclpy, _NODE_NAMES).nodes]

    def count_publishers(self, topic_name: str) -> int:
        """Return the number of publishers of a topic."""
        return _count(self._rclpy, 'publishers', self._rclpy.graph.publishers, topic_name)

    def count_subscribers(self, topic_name: str) -> int:
        """Return the number of subscriptions of a topic."""
        return _count(self._rclpy, 'subscribers', self._rclpy.graph.subscriptions, topic_name)

    def count_clients(self, service_name: str) -> int:
        """Return the number of clients of a service."""
        return _count(self._rclpy, 'clients', self._rclpy.graph.clients, service_name)

    def count_services(self, service_name: str) -> int:
        """Return the number of servers of a service."""
        return _count(self._rclpy, 'services', self._rclpy.graph.services, service_name)

    def get_publishers_info_by_topic(self, topic_name: str, no_mangle: bool = False) -> list[TopicEndpointInfo]:
        """Return the publishers of a topic. With `no_mangle`, return an empty list, because all simulated topics have names of
        ROS 2.
        """
        return _infos(self._rclpy, 'publishers', {} if no_mangle else self._rclpy.graph.publishers, topic_name)

    def get_subscriptions_info_by_topic(self, topic_name: str, no_mangle: bool = False) -> list[TopicEndpointInfo]:
        """Return the subscriptions of a topic. With `no_mangle`, return an empty list, because all simulated topics have names of
        ROS 2.
        """
        return _infos(self._rclpy, 'subscriptions', {} if no_mangle else self._rclpy.graph.subscriptions, topic_name)

    def wait_for_node(self, fully_qualified_node_name: str, timeout: float) -> bool:
        """Wait for a node with a fully qualified name, and return whether it exists.

        As in rclpy, the method sleeps for 0.1 s after each check, even if the node exists. With a timeout of 0, it does not
        check.

        :param timeout: the longest wait in seconds.
        """
        name = '/' + fully_qualified_node_name.removeprefix('/')
        sim = current_task().sim
        start_ns = sim.now_ns
        found = False
        while not found and (sim.now_ns - start_ns) / 1e9 < timeout:
            found = name in self.get_fully_qualified_node_names()
            current_task().sleep_until(sim.now_ns + 100_000_000)
        return found


def names_and_types(endpoints: list[Any], attribute: str) -> NamesAndTypes:
    """Return (name, sorted types) for the topics or services of endpoints, sorted by name."""
    found: dict[str, set[str]] = {}
    for endpoint in endpoints:
        found.setdefault(getattr(endpoint, attribute), set()).add(endpoint.type_name)
    return [(name, sorted(types)) for name, types in sorted(found.items())]


_KINDS = {'subscription': 'subscriber'}
_NODE_NAMES = 'Failed to get node names'


def _looked_at(core: NodeCore, what: str) -> Graph:
    """Return the graph. Advance simulated time if the program only queries the graph in a loop.

    :param what: the beginning of the error message after shutdown.
    """
    core.check_usable(what)
    current_task().poll()
    graph: Graph = core.graph
    return graph


def _by_node(core: NodeCore, name: str, namespace: str, kind: str, attribute: str) -> NamesAndTypes:
    ends = [end for node in _nodes(core, name, namespace, kind) for end in node.endpoints if end.kind == kind]
    return names_and_types(ends, attribute)


def _topics_by_node(core: NodeCore, name: str, namespace: str, kind: str, directions: Directions | None) -> NamesAndTypes:
    if directions is None:
        return _by_node(core, name, namespace, kind, 'topic_name')
    return dds_names_and_types([end for node in _nodes(core, name, namespace, kind) for end in node.endpoints], directions)


def _nodes(core: NodeCore, name: str, namespace: str, kind: str) -> list[Any]:
    """Return the nodes with the given name. Raise NodeNameNonExistentError for an unknown name."""
    namespace = namespace or '/'
    what = _KINDS.get(kind, kind)
    graph = _looked_at(core, f'failed to get {what} names and types')
    problem = namespace_problem(namespace) or node_name_problem(name)
    if problem is not None:
        raise RCLError(f'failed to get {what} names and types: {problem[0]}, result: {2 if name else 1}')
    nodes = [node for node in graph.nodes if node.name == name and node.namespace == namespace]
    if not nodes:
        wanted = fully_qualified_name(namespace, name)
        space, _, near = (nearest(wanted, [node.fully_qualified_name for node in graph.nodes]) or '').rpartition('/')
        raise with_facts(
            NodeNameNonExistentError(f'cannot get {what} names and types for nonexistent node: error not set'),
            'programs.no-such-node',
            node=wanted,
            near=near or None,
            space=space or '/',
        )
    return nodes


def _count(core: NodeCore, what: str, table: dict[str, list[Any]], name: str) -> int:
    core.check_usable(f'Error in rcl_count_{what}')
    current_task().poll()
    return len(table.get(_expanded(core, name), ()))


def _infos(core: NodeCore, what: str, table: dict[str, list[Any]], name: str) -> list[TopicEndpointInfo]:
    from rclpy.topic_endpoint_info import endpoint_info

    core.check_usable(f'Failed to get information by topic for {what}')
    _expanded(core, name)
    return [endpoint_info(end) for end in table.get(core.resolve(name, 'topic'), ())]


def _expanded(core: NodeCore, name: str) -> str:
    """Return the absolute form of a name. Raise ValueError if it breaks the rules, as these methods of rclpy do."""
    problem = topic_name_problem(name) if isinstance(name, str) else None
    if problem is not None:
        raise ValueError(f"topic name '{name}' is invalid: {problem[0]}")
    return core.resolve(name, 'topic', only_expand=True)


def _all(table: dict[str, list[Any]]) -> list[Any]:
    return [endpoint for endpoints in table.values() for endpoint in endpoints]
