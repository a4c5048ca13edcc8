"""`ros2 component load`: load a component into a container."""

from __future__ import annotations

import argparse

from edulaunch.cli.ros2 import cli_node, component_containers


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The container and the component."""
    component_containers.add_arguments(parser)
    component_containers.add_load_arguments(parser)


def main(arguments: argparse.Namespace) -> str | None:
    """Ask the container, and print the number that the node has there."""
    with cli_node.cli_node(arguments) as node:
        return component_containers.load(node, component_containers.container(node, arguments.container_node_name), arguments)
