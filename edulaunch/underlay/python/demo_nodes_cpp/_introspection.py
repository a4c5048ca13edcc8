"""What the two introspection programs share: a string parameter that says how much of each call is published."""

from __future__ import annotations

from typing import Any

from rcl_interfaces.msg import SetParametersResult
from rclcpp_like import CppNode
from rclpy.parameter import Parameter
from rclpy.qos import qos_profile_system_default
from rclpy.service_introspection import ServiceIntrospectionState

STATES = {
    'disabled': ServiceIntrospectionState.OFF,
    'metadata': ServiceIntrospectionState.METADATA,
    'contents': ServiceIntrospectionState.CONTENTS,
}


def follow_parameter(node: CppNode, name: str, end: Any) -> None:
    """Declare the parameter, and configure the service or client `end` whenever it is set."""

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
