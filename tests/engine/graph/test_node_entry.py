"""The names of a node in the graph."""

from __future__ import annotations

import pytest

from edulaunch.engine.graph.node_entry import NodeEntry


@pytest.mark.parametrize(
    ('name', 'namespace', 'full', 'logger'),
    [('sim', '/', '/sim', 'sim'), ('sim', '/turtlesim2', '/turtlesim2/sim', 'turtlesim2.sim'), ('c', '/a/b', '/a/b/c', 'a.b.c')],
)
def test_a_node_has_a_full_name_and_a_logger(name: str, namespace: str, full: str, logger: str) -> None:
    node = NodeEntry('process', name, namespace, 4)
    assert (node.fully_qualified_name, node.logger_name, repr(node)) == (full, logger, f'<node {full}>')
    assert (node.process, node.participant, node.index, node.endpoints) == ('process', 'process', 4, [])
