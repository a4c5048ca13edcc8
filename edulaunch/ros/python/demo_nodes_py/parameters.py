"""The programs async_param_client, which requests the parameters of another node, and set_parameters_callback."""

from __future__ import annotations

import os
from typing import Any

import rclpy
from ament_index_python.packages import get_package_share_directory
from rcl_interfaces.msg import SetParametersResult
from rclpy.node import Node
from rclpy.parameter import Parameter, parameter_value_to_python
from rclpy.parameter_client import AsyncParameterClient

from edulaunch.ros.running import run, spin

REMOTE = 'parameter_blackboard'
VALUES = [
    Parameter('int_parameter', Parameter.Type.INTEGER, 10),
    Parameter('bool_parameter', Parameter.Type.BOOL, False),
    Parameter('string_parameter', Parameter.Type.STRING, 'Fee Fi Fo Fum'),
]
NAMES = [parameter.name for parameter in VALUES]


def _set_list_get() -> None:
    """Send one request after the other, and wait for each reply."""
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


class SetParametersCallback(Node):
    """Shows the three callbacks of a parameter change.

    The first callback also sets param2 to 4.0. The second rejects negative values, and the third stores both values.
    """

    def __init__(self) -> None:
        super().__init__('set_parameters_callback')
        self.remembered = {name: self.declare_parameter(name, 0.0).value for name in ('param1', 'param2')}
        self.add_pre_set_parameters_callback(self._before)
        self.add_on_set_parameters_callback(self._check)
        self.add_post_set_parameters_callback(self._after)

    def _before(self, parameters: list[Parameter]) -> list[Parameter]:
        if any(parameter.name == 'param1' for parameter in parameters):
            return [*parameters, Parameter('param2', Parameter.Type.DOUBLE, 4.0)]
        return parameters

    def _check(self, parameters: list[Parameter]) -> SetParametersResult:
        for parameter in parameters:
            if parameter.name in self.remembered and not parameter.value >= 0.0:
                return SetParametersResult(successful=False, reason=f'{parameter.name} must not be negative')
        return SetParametersResult(successful=True)

    def _after(self, parameters: list[Parameter]) -> None:
        for parameter in parameters:
            if parameter.name in self.remembered:
                self.remembered[parameter.name] = parameter.value
                self.get_logger().info(f'{parameter.name} is now {parameter.value}')


def async_param_client() -> None:
    """Set, list, get, load and delete parameters of parameter_blackboard."""
    run(_set_list_get)


def set_parameters_callback() -> None:
    """Run the node that shows the three callbacks of a parameter change."""
    spin(SetParametersCallback)
