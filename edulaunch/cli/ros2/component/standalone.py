"""`ros2 component standalone`: run a component in a container of its own."""

from __future__ import annotations

import argparse

from edulaunch.cli.ros2 import cli_node, component_containers
from edulaunch.cli.ros2.output import with_help
from edulaunch.processes.children import Child
from edulaunch.processes.current import current_process

CONTAINER_PACKAGE, CONTAINER_EXECUTABLE, CONTAINER_NAME = 'rclcpp_components', 'component_container', 'standalone_container_'


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The component, and the name of the container."""
    cli_node.add_arguments(parser)
    component_containers.add_load_arguments(parser)
    parser.add_argument('-c', '--container-node-name', default=None, help='Name of the container node')


def main(arguments: argparse.Namespace) -> str | int | None:
    """Start the container, load the component, and wait for the end of the container."""
    process = current_process()
    name = arguments.container_node_name or f'{CONTAINER_NAME}{process.pid}'
    path = process.index.find_executable(CONTAINER_PACKAGE, CONTAINER_EXECUTABLE)
    if path is None:
        return with_help('No container found to run the component in', f'{CONTAINER_PACKAGE} is not here')
    container = Child(process, [path, '--ros-args', '-r', f'__node:={name}'])
    try:
        with cli_node.cli_node(arguments) as node:
            while f'/{name}' not in component_containers.found(node):
                cli_node.pause(node, 0.1)
            problem = component_containers.load(node, f'/{name}', arguments)
        return container.wait() if problem is None else problem
    finally:
        container.terminate()
