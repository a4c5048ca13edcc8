"""Nodes and endpoints come and go: who is told, in which order, and what is left."""

from __future__ import annotations

from typing import Any

import pytest

from edulaunch.engine.graph.graph import Graph
from edulaunch.engine.graph.qos import QoS
from edulaunch.engine.graph.tracer import Tracer
from edulaunch.engine.sim.simulation import Simulation


class Text:
    TYPE = 'test_msgs/msg/Text'


class Notes(Tracer):
    """Logs what it is told."""

    def __init__(self) -> None:
        self.log: list[Any] = []

    def node_added(self, node: Any) -> None:
        self.log.append(('node', node.name))

    def node_leaving(self, node: Any) -> None:
        self.log.append(('leaving', node.name, len(node.endpoints)))

    def node_removed(self, node: Any) -> None:
        self.log.append(('gone', node.name, len(node.endpoints)))

    def endpoint_added(self, kind: str, endpoint: Any) -> None:
        self.log.append((f'+ {kind}', endpoint.name))

    def endpoint_removed(self, kind: str, endpoint: Any) -> None:
        self.log.append((f'- {kind}', endpoint.name))


@pytest.fixture
def notes() -> Notes:
    return Notes()


@pytest.fixture
def graph(notes: Notes) -> Graph:
    made = Graph(Simulation(), notes)
    made.on_change.append(lambda: notes.log.append(made.changes))
    return made


def test_each_change_is_told_to_the_tracer_and_then_counted(graph: Graph, notes: Notes) -> None:
    node = graph.add_node('program', 'a', '/')
    publisher = graph.create_publisher(node, '/t', Text, QoS())
    heard = graph.create_subscription(node, '/t', Text, QoS(), lambda: None)
    assert (node.index, [end.kind for end in node.endpoints], graph.last_index) == (1, ['publisher', 'subscription'], 3)
    assert (graph.publishers, graph.subscriptions) == ({'/t': [publisher]}, {'/t': [heard]})
    graph.remove_end(publisher)
    graph.remove_end(publisher)
    assert (publisher.destroyed, graph.publishers, node.endpoints) == (True, {}, [heard])
    assert notes.log == [('node', 'a'), 1, ('+ publisher', '/t'), 2, ('+ subscription', '/t'), 3, ('- publisher', '/t'), 4]


def test_a_node_leaves_with_its_endpoints_and_only_once(graph: Graph, notes: Notes) -> None:
    node = graph.add_node('program', 'a', '/')
    graph.create_publisher(node, '/t', Text, QoS())
    other = graph.create_publisher(graph.add_node('program', 'b', '/'), '/t', Text, QoS())
    notes.log.clear()
    graph.remove_node(node)
    graph.remove_node(node)
    assert notes.log == [('leaving', 'a', 1), ('- publisher', '/t'), 5, ('gone', 'a', 0), 6]
    assert [one.name for one in graph.nodes] == ['b'] and graph.publishers == {'/t': [other]}


def test_a_process_takes_its_own_nodes_with_it(graph: Graph) -> None:
    first, second = object(), object()
    for process, name in ((first, 'a'), (second, 'b'), (first, 'c')):
        graph.add_node(process, name, '/')
    graph.remove_process(first)
    assert [node.name for node in graph.nodes] == ['b']
