"""The programs add_two_ints_server, add_two_ints_client(_async), introspection_service and introspection_client."""

from __future__ import annotations

from typing import Any

import rclpy
from example_interfaces.srv import AddTwoInts
from rcl_interfaces.msg import SetParametersResult
from rclcpp_like import CppNode, program, spinning
from rclpy.parameter import Parameter
from rclpy.qos import qos_profile_system_default
from rclpy.service_introspection import ServiceIntrospectionState

STATES = {
    'disabled': ServiceIntrospectionState.OFF,
    'metadata': ServiceIntrospectionState.METADATA,
    'contents': ServiceIntrospectionState.CONTENTS,
}


class AddTwoIntsServer(CppNode):
    """Serves the service `add_two_ints`."""

    def __init__(self, node_name: str = 'add_two_ints_server', **options: Any) -> None:
        super().__init__(node_name, **options)
        self._service = self.create_service(AddTwoInts, 'add_two_ints', self._on_request)

    def _on_request(self, request: Any, response: Any) -> Any:
        self.get_logger().info(f'Incoming request\na: {request.a} b: {request.b}')
        response.sum = request.a + request.b
        return response


def ask() -> int:
    """Send one request, and return the exit code: 0, or 1 if no reply arrives."""
    node = CppNode('add_two_ints_client')
    client = node.create_client(AddTwoInts, 'add_two_ints')
    while not client.wait_for_service(timeout_sec=1.0):
        if not rclpy.ok():
            node.get_logger().error('Interrupted while waiting for the service. Exiting.')
            return 0
        node.get_logger().info('service not available, waiting again...')
    reply = client.call_async(AddTwoInts.Request(a=2, b=3))
    rclpy.spin_until_future_complete(node, reply)
    answer = reply.result()
    if answer is None:
        node.get_logger().error('Interrupted while waiting for response. Exiting.')
        return 1
    node.get_logger().info(f'Result of add_two_ints: {answer.sum}')
    return 0


def follow_parameter(node: CppNode, name: str, end: Any) -> None:
    """Declare the parameter, and configure the service or client `end` whenever the parameter is set."""

    def check(parameters: list[Parameter]) -> SetParametersResult:
        for parameter in parameters:
            if parameter.name == name and parameter.type_ != Parameter.Type.STRING:
                return SetParametersResult(successful=False, reason='must be a string')
            if parameter.name == name and parameter.value not in STATES:
                return SetParametersResult(successful=False, reason='must be one of "disabled", "metadata", or "contents"')
        return SetParametersResult(successful=True)

    def configure(parameters: list[Parameter]) -> None:
        for parameter in parameters:
            if parameter.name == name:
                end.configure_introspection(node.get_clock(), qos_profile_system_default, STATES[parameter.value])

    node.add_on_set_parameters_callback(check)
    node.add_post_set_parameters_callback(configure)
    node.declare_parameter(name, 'disabled')


class IntrospectionService(AddTwoIntsServer):
    """Serves `add_two_ints`, and publishes service events as its parameter specifies."""

    def __init__(self, **options: Any) -> None:
        super().__init__('introspection_service', **options)
        follow_parameter(self, 'service_configure_introspection', self._service)


class IntrospectionClient(CppNode):
    """Requests 2 + 3 twice a second, one request at a time, and publishes service events as its parameter specifies."""

    def __init__(self, **options: Any) -> None:
        super().__init__('introspection_client', **options)
        self._client = self.create_client(AddTwoInts, 'add_two_ints')
        self._waits = False
        follow_parameter(self, 'client_configure_introspection', self._client)
        self._timer = self.create_wall_timer(0.5, self._on_timer)

    def _on_timer(self) -> None:
        if self._waits or not self._client.service_is_ready():
            return
        self._waits = True
        self._client.call_async(AddTwoInts.Request(a=2, b=3)).add_done_callback(self._on_answer)

    def _on_answer(self, future: Any) -> None:
        self._waits = False
        self.get_logger().info(f'Result of add_two_ints: {future.result().sum}')


add_two_ints_server = spinning(AddTwoIntsServer)
add_two_ints_client = add_two_ints_client_async = program(ask)
introspection_service = spinning(IntrospectionService)
introspection_client = spinning(IntrospectionClient)
