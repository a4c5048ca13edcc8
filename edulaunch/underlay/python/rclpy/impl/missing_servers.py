"""Requests that nobody will answer: ROS 2 keeps silent about them, here the recording says so."""

from __future__ import annotations

from typing import Any

from edulaunch.nearest import nearest
from edulaunch.processes.current import current_process
from rclpy.impl.student_place import student_place

LONG_NS = 10_000_000_000
"""How long a client waits for a server until that is worth a note."""


def note_lost_request(endpoint: Any, name: str, kind: str) -> None:
    """Note a request to a service or action (`kind`) that has no server.

    :param endpoint: the client in the graph; of an action, the one that sends goals.
    """
    wait = 'wait_for_service' if kind == 'service' else 'wait_for_server'
    current_process().note(
        'lost request',
        (
            f"{_who(endpoint)} asks {kind} '{name}', but {_problem(endpoint, name, kind)}, so the request is lost and no answer "
            'will '
            f'ever come. Wait for the server first: client.{wait}()'
        ),
    )


def note_long_wait(endpoint: Any, name: str, kind: str) -> None:
    """Note that a client waits and waits."""
    current_process().note(
        'no server',
        (f"{_who(endpoint)} has waited {LONG_NS // 10**9} s for {kind} '{name}', but {_problem(endpoint, name, kind)}"),
    )


def _who(endpoint: Any) -> str:
    return f"node '{endpoint.node.fully_qualified_name}'{student_place()}"


def _problem(endpoint: Any, name: str, kind: str) -> str:
    services: dict[str, list[Any]] = endpoint.graph.services
    others = services.get(endpoint.service_name)
    if others:
        return f'its server has the type {others[0].type_name}, the client {endpoint.type_name}'
    ending = endpoint.service_name[len(name) :]
    known = [one[: len(one) - len(ending)] for one in services if one.endswith(ending)]
    near = nearest(name, known)
    return 'nobody offers it' if near is None else f"nobody offers it (did you mean '{near}'?)"
