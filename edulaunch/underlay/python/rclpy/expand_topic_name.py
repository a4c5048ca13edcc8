"""From a name as a program writes it to its absolute form."""
from __future__ import annotations

from edulaunch.graph.names import expand_name


def expand_topic_name(topic_name: str, node_name: str, node_namespace: str) -> str:
    """The absolute form of a topic or service name in a node; remap rules are not applied."""
    return expand_name(topic_name, node_name, node_namespace)
