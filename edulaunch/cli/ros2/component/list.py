"""`ros2 component list`: the containers and what is loaded into them."""

from __future__ import annotations

import argparse

from edulaunch.cli.ros2 import cli_node, component_containers
from edulaunch.cli.ros2.output import say


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """One container, or all."""
    cli_node.add_arguments(parser)
    parser.add_argument('container_node_name', nargs='?', help='Container node name to list components from')
    parser.add_argument('--containers-only', action='store_true', help='List found containers nodes only')


def main(arguments: argparse.Namespace) -> None:
    """Print each container and, two spaces further in, number and name of its nodes."""
    wanted = arguments.container_node_name
    with cli_node.cli_node(arguments) as node:
        for name in component_containers.found(node) if wanted is None else [component_containers.container(node, wanted)]:
            if wanted is None:
                say(name)
            for number, component in [] if arguments.containers_only else component_containers.components(node, name):
                say(f'  {number}  {component}')
