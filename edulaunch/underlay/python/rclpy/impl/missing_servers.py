"""Requests that nobody will answer: ROS 2 keeps silent about them, here facts are kept, of which advice is made."""

from __future__ import annotations

from typing import Any

from edulaunch.processes.current import current_process
from edulaunch.processes.student_line import student_line

LONG_NS = 1_000_000_000
"""How long a client waits for a server until that is worth a fact."""


def note_lost_request(endpoint: Any, name: str, kind: str) -> None:
    """A request to a service or action (`kind`) that has no server.

    :param endpoint: the client in the graph; of an action, the one that sends goals.
    """
    _note('request lost', endpoint, name, kind)


def note_long_wait(endpoint: Any, name: str, kind: str) -> None:
    """A client waits and waits."""
    _note('server awaited', endpoint, name, kind)


def note_server_came(endpoint: Any, name: str) -> None:
    """The server that a client has waited for is there after all."""
    current_process().fact_over('server awaited', (endpoint.node.index, name))


def _note(what: str, endpoint: Any, name: str, kind: str) -> None:
    data = {'node': endpoint.node.fully_qualified_name, 'name': name, 'kind': kind, **student_line()}
    current_process().fact(what, (endpoint.node.index, name), data)
