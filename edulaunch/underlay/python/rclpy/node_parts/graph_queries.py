"""What a node can ask about the graph."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any

from edulaunch.graph.names import absolute_namespace
from edulaunch.sim.task import current_task
from rclpy._rclpy_pybind11 import NodeNameNonExistentError
from rclpy.node_parts.core import NodeCore

if TYPE_CHECKING:
    from edulaunch.graph.graph import Graph
    from rclpy.topic_endpoint_info import TopicEndpointInfo

NamesAndTypes = list[tuple[str, list[str]]]


class NodeGraphQueries:
    """The part of `Node` that asks about other nodes, topics and services. Names are fully qualified and sorted."""

    _rclpy: NodeCore

    def get_topic_names_and_types(self, no_demangle: bool = False) -> NamesAndTypes:
        """All topics with their types."""
        graph = _looked_at(self._rclpy)
        return names_and_types([*_all(graph.publishers), *_all(graph.subscriptions)], 'topic_name')

    def get_service_names_and_types(self) -> NamesAndTypes:
        """All services that have a server, with their types."""
        return names_and_types(_all(_looked_at(self._rclpy).services), 'service_name')

    def get_publisher_names_and_types_by_node(self, node_name: str, node_namespace: str,
                                              no_demangle: bool = False) -> NamesAndTypes:
        """The topics that a node publishes. Raises NodeNameNonExistentError for an unknown node."""
        return _by_node(self._rclpy, node_name, node_namespace, 'publisher', 'topic_name')

    def get_subscriber_names_and_types_by_node(self, node_name: str, node_namespace: str,
                                               no_demangle: bool = False) -> NamesAndTypes:
        """The topics that a node subscribes to. Raises NodeNameNonExistentError for an unknown node."""
        return _by_node(self._rclpy, node_name, node_namespace, 'subscription', 'topic_name')

    def get_service_names_and_types_by_node(self, node_name: str, node_namespace: str) -> NamesAndTypes:
        """The services that a node offers. Raises NodeNameNonExistentError for an unknown node."""
        return _by_node(self._rclpy, node_name, node_namespace, 'service', 'service_name')

    def get_client_names_and_types_by_node(self, node_name: str, node_namespace: str) -> NamesAndTypes:
        """The services that a node has clients of. Raises NodeNameNonExistentError for an unknown node."""
        return _by_node(self._rclpy, node_name, node_namespace, 'client', 'service_name')

    def get_node_names(self) -> list[str]:
        """The own names of all nodes, in order of creation."""
        return [node.name for node in _looked_at(self._rclpy).nodes]

    def get_fully_qualified_node_names(self) -> list[str]:
        """The full names of all nodes."""
        return [node.fully_qualified_name for node in _looked_at(self._rclpy).nodes]

    def get_node_names_and_namespaces(self) -> list[tuple[str, str]]:
        """(name, namespace) of all nodes."""
        return [(node.name, node.namespace) for node in _looked_at(self._rclpy).nodes]

    def get_node_names_and_namespaces_with_enclaves(self) -> list[tuple[str, str, str]]:
        """(name, namespace, enclave) of all nodes; the enclave is always '/'."""
        return [(node.name, node.namespace, '/') for node in self._rclpy.graph.nodes]

    def count_publishers(self, topic_name: str) -> int:
        """How many publishers a topic has."""
        return _count(self._rclpy, self._rclpy.graph.publishers, topic_name, 'topic')

    def count_subscribers(self, topic_name: str) -> int:
        """How many subscriptions a topic has."""
        return _count(self._rclpy, self._rclpy.graph.subscriptions, topic_name, 'topic')

    def count_clients(self, service_name: str) -> int:
        """How many clients a service has."""
        return _count(self._rclpy, self._rclpy.graph.clients, service_name, 'service')

    def count_services(self, service_name: str) -> int:
        """How many servers a service has."""
        return _count(self._rclpy, self._rclpy.graph.services, service_name, 'service')

    def get_publishers_info_by_topic(self, topic_name: str, no_mangle: bool = False) -> list[TopicEndpointInfo]:
        """The publishers of a topic."""
        from rclpy.topic_endpoint_info import endpoint_info
        name = self._rclpy.resolve(topic_name, 'topic')
        return [endpoint_info(end) for end in self._rclpy.graph.publishers.get(name, ())]

    def get_subscriptions_info_by_topic(self, topic_name: str, no_mangle: bool = False) -> list[TopicEndpointInfo]:
        """The subscriptions of a topic."""
        from rclpy.topic_endpoint_info import endpoint_info
        name = self._rclpy.resolve(topic_name, 'topic')
        return [endpoint_info(end) for end in self._rclpy.graph.subscriptions.get(name, ())]

    def wait_for_node(self, fully_qualified_node_name: str, timeout: float) -> bool:
        """Wait at most `timeout` seconds for a node of that full name, looking each 0.1 s; whether it is there."""
        task = current_task()
        deadline = task.sim.now_ns + int(timeout * 1e9)
        while fully_qualified_node_name not in self.get_fully_qualified_node_names():
            if task.sim.now_ns >= deadline or not self._rclpy.context._ok:
                return False
            task.sleep_until(min(task.sim.now_ns + 100_000_000, deadline))
        return True


def names_and_types(endpoints: list[Any], attribute: str) -> NamesAndTypes:
    """(name, sorted types) of endpoints, sorted by name."""
    found: dict[str, set[str]] = {}
    for endpoint in endpoints:
        found.setdefault(getattr(endpoint, attribute), set()).add(endpoint.type_name)
    return [(name, sorted(types)) for name, types in sorted(found.items())]


def _looked_at(core: NodeCore) -> Graph:
    """The graph; a loop that does nothing but look at it is moved on by simulated time."""
    core.check_alive()
    current_task().poll()
    graph: Graph = core.graph
    return graph


def _by_node(core: NodeCore, name: str, namespace: str, kind: str, attribute: str) -> NamesAndTypes:
    namespace = absolute_namespace(namespace)
    nodes = [node for node in core.graph.nodes if node.name == name and node.namespace == namespace]
    if not nodes:
        raise NodeNameNonExistentError(
            f"cannot get names and types for nonexistent node: name '{name}', namespace '{namespace}'")
    return names_and_types([end for node in nodes for end in node.endpoints if end.kind == kind], attribute)


def _count(core: NodeCore, table: dict[str, Any], name: str, kind: str) -> int:
    current_task().poll()
    return len(table.get(core.resolve(name, kind, only_expand=True), ()))


def _all(table: dict[str, list[Any]]) -> list[Any]:
    return [endpoint for endpoints in table.values() for endpoint in endpoints]
