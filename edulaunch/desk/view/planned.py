"""Build the page of a planned system, which shows the graph of nodes, topics and frames before anything runs."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from edulaunch.desk.view.page import recorded_page

if TYPE_CHECKING:
    from edulaunch.advice.explaining.systems import System


def planned_page(system: System) -> str:
    """Return the page as HTML. The page needs no other file and no network."""
    return recorded_page(planned_delta(system), system.title, small=True)


def planned_delta(system: System) -> dict[str, Any]:
    """Return the system as a timeline with a length of zero (see `edulaunch.desk.view.timeline`).

    The part `planned` of the timeline contains

    * `frames`: [parent, child, is static, nodes] of each frame;
    * `unknown`: a description of the unknown parts of each node;
    * `source`: the origin of the endpoints of each node.
    """
    nodes = list(enumerate(system.nodes))
    return {
        'start': 0,
        'now': 0,
        'nodes': [[number, node.name, node.program, number, 0, None] for number, node in nodes],
        'endpoints': [[0, kind, name, type, number, number, []] for number, node in nodes for kind, name, type in node.ends],
        'parameters': [
            [0, node.name, name, value, 'the launch file', isinstance(value, float)]
            for _, node in nodes
            for name, value in node.parameters.items()
        ],
        'planned': {
            'frames': [[frame.parent, frame.child, frame.is_static, frame.by] for frame in system.frames],
            'unknown': {node.name: node.unknown for _, node in nodes if node.unknown},
            'source': {node.name: node.source for _, node in nodes},
        },
    }
