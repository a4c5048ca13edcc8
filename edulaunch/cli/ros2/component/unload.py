"""`ros2 component unload`: take components out of a container."""

from __future__ import annotations

import argparse

from edulaunch.cli.ros2 import cli_node, component_containers
from edulaunch.cli.ros2.output import say


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The container and the numbers."""
    component_containers.add_arguments(parser)
    parser.add_argument('component_uid', nargs='+', type=int, help='Unique ID of the component node to be unloaded')


def main(arguments: argparse.Namespace) -> str | None:
    """Unload one after another; ends at the first that fails."""
    from composition_interfaces.srv import UnloadNode

    with cli_node.cli_node(arguments) as node:
        name = component_containers.container(node, arguments.container_node_name)
        for number in arguments.component_uid:
            answer = cli_node.call(node, f'{name}/_container/unload_node', UnloadNode, unique_id=number)
            if not answer.success:
                return f"Failed to unload component {number} from '{name}' container node\n    {answer.error_message}"
            say(f"Unloaded component {number} from '{name}' container node")
    return None
