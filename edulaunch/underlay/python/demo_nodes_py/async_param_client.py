"""The program async_param_client: sets, lists, gets, loads and deletes parameters of parameter_blackboard."""

from __future__ import annotations

import os
from typing import Any

import rclpy
from ament_index_python.packages import get_package_share_directory
from rclpy.node import Node
from rclpy.parameter import Parameter, parameter_value_to_python
from rclpy.parameter_client import AsyncParameterClient

from demo_nodes_py._running import run

REMOTE = 'parameter_blackboard'
VALUES = [
    Parameter('int_parameter', Parameter.Type.INTEGER, 10),
    Parameter('bool_parameter', Parameter.Type.BOOL, False),
    Parameter('string_parameter', Parameter.Type.STRING, 'Fee Fi Fo Fum'),
]
NAMES = [parameter.name for parameter in VALUES]


def work() -> None:
    """One request after the other, each waited for."""
    node = rclpy.create_node('async_param_client')
    client = AsyncParameterClient(node, REMOTE)
    log = node.get_logger()
    while not client.wait_for_services(1.0):
        log.info(f'{REMOTE} is not available, waiting again...')
    log.info('Setting parameters:')
    _say_results(node, NAMES, client.set_parameters(VALUES))
    log.info('Listing Parameters:')
    for name in sorted(_reply(node, client.list_parameters(NAMES, 10)).result.names):
        log.info(f'    - {name}')
    log.info('Getting parameters:')
    for name, value in zip(NAMES, _reply(node, client.get_parameters(NAMES)).values, strict=False):
        log.info(f'    - {name}: {parameter_value_to_python(value)}')
    log.info('Loading parameters:')
    file = os.path.join(get_package_share_directory('demo_nodes_py'), 'params.yaml')
    _say_results(node, ['int_parameter', 'string_parameter'], client.load_parameter_file(file))
    log.info('Deleting parameters:')
    _say_results(node, NAMES, client.delete_parameters(NAMES))


def _reply(node: Node, future: Any) -> Any:
    rclpy.spin_until_future_complete(node, future)
    return future.result()


def _say_results(node: Node, names: list[str], future: Any) -> None:
    for name, result in zip(names, _reply(node, future).results, strict=False):
        node.get_logger().info(f'    {name}:')
        node.get_logger().info(f'        successful: {result.successful}')
        if result.reason:
            node.get_logger().info(f'        reason: {result.reason}')


def main() -> None:
    """Run the program until Ctrl-C or a shutdown."""
    run(work)


if __name__ == '__main__':
    main()
