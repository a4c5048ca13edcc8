"""The entry of a node in the graph."""

from __future__ import annotations

from typing import Any


class NodeEntry:
    """The entry of a node in the graph. `endpoints` are in order of creation.

    :ivar participant: the owner of the DDS participant, which is the process or the context that created the node.
    """

    def __init__(self, process: Any, name: str, namespace: str, index: int) -> None:
        self.process = process
        self.name = name
        self.namespace = namespace
        self.index = index
        self.participant: object = process
        self.endpoints: list[Any] = []

    @property
    def fully_qualified_name(self) -> str:
        """The namespace and the name of the node, such as '/turtlesim2/sim'."""
        return ('' if self.namespace == '/' else self.namespace) + '/' + self.name

    @property
    def logger_name(self) -> str:
        """The fully qualified name with dots instead of slashes: 'a.b.c' for node c in /a/b."""
        return self.fully_qualified_name[1:].replace('/', '.')

    def __repr__(self) -> str:
        return f'<node {self.fully_qualified_name}>'
