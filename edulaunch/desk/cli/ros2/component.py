"""`ros2 component`: list, load and unload the components of containers."""

from __future__ import annotations

import argparse
from typing import TYPE_CHECKING, Any

from edulaunch.desk.cli.ros2 import cli_node, graph_names
from edulaunch.desk.cli.ros2.output import say, say_lines, with_help
from edulaunch.engine.nearest import did_you_mean
from edulaunch.engine.processes.current import current_process

if TYPE_CHECKING:
    from rclpy.node import Node

_LIST = '/_container/list_nodes'
RESOURCE_TYPE = 'rclcpp_components'
CONTAINER_PACKAGE, CONTAINER_EXECUTABLE, CONTAINER_NAME = 'rclcpp_components', 'component_container', 'standalone_container_'


def _container_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the argument for the container."""
    cli_node.add_arguments(parser)
    parser.add_argument('container_node_name', help='Container node name')


def _component_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments for the component, and the options for its node."""
    parser.add_argument('package_name', help='Package name where the component can be found')
    parser.add_argument('plugin_name', help='Type name of the component, such as composition::Talker')
    parser.add_argument('-n', '--node-name', help='Component node name')
    parser.add_argument('--node-namespace', help='Component node namespace')
    parser.add_argument('--log-level', help='Component node log level')
    parser.add_argument('-r', '--remap', dest='remap_rules', action='append', default=[], help="Remapping rule 'from:=to'")
    parser.add_argument('-p', '--parameter', dest='parameters', action='append', default=[], help="Parameter 'name:=value'")
    parser.add_argument(
        '-e', '--extra-argument', dest='extra_arguments', action='append', default=[], help="Extra argument 'name:=value'"
    )


def _containers(node: Node) -> list[str]:
    """Return the full names of all containers, sorted."""
    return sorted(name.removesuffix(_LIST) for name, _ in node.get_service_names_and_types() if name.endswith(_LIST))


def container(node: Node, name: str) -> str:
    """Return the full name of the container that the command line names.

    :raises RuntimeError: when no container has this name, with the message of ROS 2.
    """
    name, known = graph_names.absolute(name), _containers(node)
    if name not in known:
        raise RuntimeError(
            with_help(f"Unable to find container node '{name}'", did_you_mean(name, known) or 'see `ros2 component list`')
        )
    return name


def components(node: Node, name: str) -> list[tuple[int, str]]:
    """Return the number and the full name of each node in a container."""
    from composition_interfaces.srv import ListNodes

    answer = cli_node.call(node, name + _LIST, ListNodes)
    return list(zip(answer.unique_ids, answer.full_node_names, strict=True))


def load(node: Node, name: str, arguments: argparse.Namespace) -> str | None:
    """Load a component into a container, and print the result. Return an error message if that failed.

    :param node: the node of the command.
    :param name: the full name of the container.
    :param arguments: the parsed options, which describe the component.
    """
    from composition_interfaces.srv import LoadNode

    answer = cli_node.call(
        node,
        f'{name}/_container/load_node',
        LoadNode,
        package_name=arguments.package_name,
        plugin_name=arguments.plugin_name,
        node_name=arguments.node_name or '',
        node_namespace=arguments.node_namespace or '',
        log_level=_level(arguments.log_level),
        remap_rules=arguments.remap_rules,
        parameters=list(map(_parameter, arguments.parameters)),
        extra_arguments=list(map(_parameter, arguments.extra_arguments)),
    )
    if not answer.success:
        return f'Failed to load component: {answer.error_message}'.rstrip(': ').capitalize()
    say(f"Loaded component {answer.unique_id} into '{name}' container node as '{answer.full_node_name}'")
    return None


def _level(word: str | None) -> int:
    """Return the number of a log level for the service. Return 0 if the user names no level.

    :raises RuntimeError: for an unknown log level.
    """
    from rclpy.logging import get_logging_severity_from_string

    try:
        return 0 if word is None else int(get_logging_severity_from_string(word))
    except RuntimeError:
        raise RuntimeError(with_help(f"'{word}' is not a log level", 'one of: debug, info, warn, error, fatal')) from None


def _parameter(text: str) -> Any:
    from rcl_interfaces.msg import Parameter
    from rclpy.parameter import get_parameter_value

    name, sign, value = text.partition(':=')
    if not sign:
        raise RuntimeError(with_help(f"'{text}' is not a parameter", 'write name:=value'))
    return Parameter(name=name, value=get_parameter_value(value))


def list_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the argument for the container. If the user names none, the verb lists all containers."""
    cli_node.add_arguments(parser)
    parser.add_argument('container_node_name', nargs='?', help='Container node name to list components from')
    parser.add_argument('--containers-only', action='store_true', help='List found containers nodes only')


def list_verb(arguments: argparse.Namespace) -> None:
    """Print each container. Below it, print the number and the name of each of its nodes, indented by two spaces."""
    wanted = arguments.container_node_name
    with cli_node.cli_node(arguments) as node:
        for name in _containers(node) if wanted is None else [container(node, wanted)]:
            if wanted is None:
                say(name)
            for number, component in [] if arguments.containers_only else components(node, name):
                say(f'  {number}  {component}')


def load_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments for the container and the component."""
    _container_arguments(parser)
    _component_arguments(parser)


def load_verb(arguments: argparse.Namespace) -> str | None:
    """Load the component, and print the number of its node in the container."""
    with cli_node.cli_node(arguments) as node:
        return load(node, container(node, arguments.container_node_name), arguments)


def standalone_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments for the component, and an option for the name of the container."""
    cli_node.add_arguments(parser)
    _component_arguments(parser)
    parser.add_argument('-c', '--container-node-name', default=None, help='Name of the container node')


def standalone_verb(arguments: argparse.Namespace) -> str | int | None:
    """Start a container, load the component, and wait until the container ends."""
    from edulaunch.engine.processes.children import Child

    process = current_process()
    name = arguments.container_node_name or f'{CONTAINER_NAME}{process.pid}'
    path = process.index.find_executable(CONTAINER_PACKAGE, CONTAINER_EXECUTABLE)
    if path is None:
        return with_help('No container found to run the component in', f'{CONTAINER_PACKAGE} is not installed')
    container = Child(process, [path, '--ros-args', '-r', f'__node:={name}'])
    try:
        with cli_node.cli_node(arguments) as node:
            while f'/{name}' not in _containers(node):
                cli_node.pause(node, 0.1)
            problem = load(node, f'/{name}', arguments)
        return container.wait() if problem is None else problem
    finally:
        container.terminate()


def types_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the argument for the package. If the user names none, the verb lists the components of all packages."""
    parser.add_argument('package_name', nargs='?', help='Package name to list components from')


def types_verb(arguments: argparse.Namespace) -> str | None:
    """Print the component types of one package. If the user names no package, print the name and the types of each package."""
    wanted, packages = arguments.package_name, _registered()
    if wanted is not None and wanted not in packages:
        return with_help(f"Cannot find package '{wanted}' or it has no components", did_you_mean(wanted, packages))
    for package in sorted(packages) if wanted is None else [wanted]:
        found = packages[package]
        if wanted is None:
            say(package)
        say_lines(found if wanted is not None else [f'  {name}' for name in found])
    return None


def _registered() -> dict[str, list[str]]:
    """Return the component types of each package.

    They come from the package's components.txt or, for an installed package, from the ament index.
    """
    from ament_index_python import get_resource, get_resources
    from rclcpp_components.component_container import components_of, packages_with_components

    index = current_process().index
    found = {package: list(components_of(index, package)) for package in packages_with_components(index)}
    for package in get_resources(RESOURCE_TYPE):
        text = get_resource(RESOURCE_TYPE, package)[0]
        found.setdefault(package, [line.partition(';')[0] for line in text.splitlines() if line.strip()])
    return found


def unload_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments for the container and for the numbers of the components."""
    _container_arguments(parser)
    parser.add_argument('component_uid', nargs='+', type=int, help='Unique ID of the component node to be unloaded')


def unload_verb(arguments: argparse.Namespace) -> str | None:
    """Unload the components in the given order. Stop when one of them cannot be unloaded."""
    from composition_interfaces.srv import UnloadNode

    with cli_node.cli_node(arguments) as node:
        name = container(node, arguments.container_node_name)
        for number in arguments.component_uid:
            answer = cli_node.call(node, f'{name}/_container/unload_node', UnloadNode, unique_id=number)
            if not answer.success:
                return f"Failed to unload component {number} from '{name}' container node\n    {answer.error_message}"
            say(f"Unloaded component {number} from '{name}' container node")
    return None
