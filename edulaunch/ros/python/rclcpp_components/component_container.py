"""The programs component_container*. Each is one process for many nodes, which service calls load and unload."""

from __future__ import annotations

import os
import sys
from collections.abc import Callable
from importlib import import_module
from typing import TYPE_CHECKING, Any

from composition_interfaces.srv import ListNodes, LoadNode, UnloadNode
from rclcpp_like import CppNode, run_program
from rclpy.executors import Executor, MultiThreadedExecutor, SingleThreadedExecutor
from rclpy.node import Node
from rclpy.parameter import Parameter

from edulaunch.engine.processes.current import current_process
from edulaunch.engine.underlay_place import underlay_prefix

if TYPE_CHECKING:
    from edulaunch.engine.packages import Index


def components_of(index: Index, package: str) -> dict[str, str]:
    """Return the factories (`module:name`) of a package's components, by component name (`demo_nodes_cpp::Talker`).

    A copy of a ROS 2 package in a workspace has the built-in components.
    """
    if index.share(package) is None:
        return {}
    try:
        with open(os.path.join(underlay_prefix(), 'share', package, 'components.txt'), encoding='utf-8') as file:
            pairs = [line.partition(' = ') for line in file.read().splitlines()]
    except OSError:
        return {}
    return {name: target for name, _, target in pairs}


def packages_with_components(index: Index) -> list[str]:
    """Return the names of the packages that have components, sorted."""
    return [package for package in index.packages() if components_of(index, package)]


def factory_of(target: str) -> Callable[..., Any]:
    """Return the factory at `module:name`, which creates a node from the options of a Node."""
    module, _, name = target.partition(':')
    found: Callable[..., Any] = getattr(import_module(module), name)
    return found


FACTORY = 'rclcpp_components::NodeFactoryTemplate<{}>'


class ComponentManager(CppNode):
    """Creates nodes in its own process, numbers them from 1, and adds them to its executor."""

    def __init__(self, executor: Executor) -> None:
        super().__init__('ComponentManager')
        self._executor = executor
        self._nodes: dict[int, Node] = {}
        self._count = 0
        self.create_service(LoadNode, '~/_container/load_node', self._on_load)
        self.create_service(UnloadNode, '~/_container/unload_node', self._on_unload)
        self.create_service(ListNodes, '~/_container/list_nodes', self._on_list)

    def _on_load(self, request: Any, response: Any) -> Any:
        index = current_process().index
        known = components_of(index, request.package_name)
        if not known:
            return self._refuse(response, 'Could not find requested resource in ament index', self._why_not(request))
        for name, target in known.items():
            if name == request.plugin_name:
                self._load(request, response, target)
                return response
        return self._refuse(response, 'Failed to find class with the requested plugin name.', self._why_not(request))

    def _load(self, request: Any, response: Any, target: str) -> None:
        log, plugin = self.get_logger(), FACTORY.format(request.plugin_name)
        library = f'lib{request.plugin_name.rpartition("::")[2].lower()}_component.so'
        log.info(f'Load Library: {current_process().index.prefix(request.package_name)}/lib/{library}')
        log.info(f'Found class: {plugin}')
        log.info(f'Instantiate class: {plugin}')
        try:
            node = factory_of(target)(**_options(request))
        except Exception as error:
            self._refuse(response, f'Component constructor threw an exception: {error}')
            return
        self._count += 1
        self._nodes[self._count] = node
        self._executor.add_node(node)
        response.success, response.unique_id = True, self._count
        response.full_node_name = node.get_fully_qualified_name()

    def _why_not(self, request: Any) -> str:
        """Return the reason why a component is missing: its package needs a C++ compiler, or has other components, or has
        none.
        """
        index, package = current_process().index, request.package_name
        if index.contents(package) is not None:
            return f'{request.plugin_name} of {package} is built from C++, which does not run here'
        known = components_of(index, package)
        return f'components of {package}: {", ".join(known)}' if known else f'no components of a package {package!r} are here'

    def _refuse(self, response: Any, message: str, help: str = '') -> Any:
        self.get_logger().error(f'{message}\n  help: {help}' if help else message)
        response.success, response.error_message = False, message
        return response

    def _on_unload(self, request: Any, response: Any) -> Any:
        node = self._nodes.pop(request.unique_id, None)
        if node is None:
            response.success, response.error_message = False, f'No node found with unique_id: {request.unique_id}'
            self.get_logger().warning(response.error_message)
            return response
        self._executor.remove_node(node)
        node.destroy_node()
        response.success = True
        return response

    def _on_list(self, request: Any, response: Any) -> Any:
        response.unique_ids = list(self._nodes)
        response.full_node_names = [node.get_fully_qualified_name() for node in self._nodes.values()]
        return response


def _options(request: Any) -> dict[str, Any]:
    """Return the options of a Node that a request describes. The container's own command line is not part of them."""
    rules = list(request.remap_rules)
    rules += [f'__node:={request.node_name}'] if request.node_name else []
    rules += [f'__ns:={request.node_namespace}'] if request.node_namespace else []
    return {
        'use_global_arguments': False,
        'cli_args': ['--ros-args', *(word for rule in rules for word in ('-r', rule))],
        'parameter_overrides': [Parameter.from_parameter_msg(message) for message in request.parameters],
    }


def _contain(executor_class: type[Executor]) -> None:
    executor = executor_class()
    executor.add_node(ComponentManager(executor))
    executor.spin()


def main() -> None:
    """Run a container with one thread. The isolated container also uses this program, although its nodes have
    separate executors.
    """
    sys.exit(run_program(lambda: _contain(SingleThreadedExecutor)))


def main_mt() -> None:
    """Run the container with several threads."""
    sys.exit(run_program(lambda: _contain(MultiThreadedExecutor)))


if __name__ == '__main__':
    main()
