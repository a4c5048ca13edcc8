"""A function that converts a name in a program to its absolute form."""

from __future__ import annotations

from edulaunch.engine.graph.names import expand_name, namespace_problem, node_name_problem, topic_name_problem


def expand_topic_name(topic_name: str, node_name: str, node_namespace: str) -> str:
    """Return the absolute form of a topic or service name of a node, without remapping.

    :raises ValueError: when the topic name, node name or namespace is invalid.
    """
    for what, name, problem in (
        ('topic name', topic_name, topic_name_problem),
        ('node name', node_name, node_name_problem),
        ('node namespace', node_namespace, namespace_problem),
    ):
        found = problem(name)
        if found is not None:
            raise ValueError(f"{what} '{name}' is invalid: {found[0]}")
    return expand_name(topic_name, node_name, node_namespace)
