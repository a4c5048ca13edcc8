"""The six services with which other nodes read and change a node's parameters."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from edulaunch.ros.passed_on import passed_on
from rclpy.exceptions import ParameterNotDeclaredException, ParameterUninitializedException
from rclpy.parameter import Parameter
from rclpy.qos import qos_profile_parameters

if TYPE_CHECKING:
    from rclpy.impl.protocols import NodeProtocol


class ParameterService:
    """Creates the services `<node>/describe_parameters`, `get_parameters`, `get_parameter_types`, `list_parameters`,
    `set_parameters` and `set_parameters_atomically`.
    """

    def __init__(self, node: NodeProtocol) -> None:
        from rcl_interfaces import srv

        self._node = node
        for name, srv_type, callback in (
            ('describe_parameters', srv.DescribeParameters, self._describe_parameters_callback),
            ('get_parameters', srv.GetParameters, self._get_parameters_callback),
            ('get_parameter_types', srv.GetParameterTypes, self._get_parameter_types_callback),
            ('list_parameters', srv.ListParameters, self._list_parameters_callback),
            ('set_parameters', srv.SetParameters, self._set_parameters_callback),
            ('set_parameters_atomically', srv.SetParametersAtomically, self._set_parameters_atomically_callback),
        ):
            node.create_service(srv_type, f'{node.get_name()}/{name}', callback, qos_profile=qos_profile_parameters)

    def _describe_parameters_callback(self, request: Any, response: Any) -> Any:
        try:
            response.descriptors = self._node.describe_parameters(request.names)
        except ParameterNotDeclaredException:
            response.descriptors = []
        return response

    def _get_parameters_callback(self, request: Any, response: Any) -> Any:
        try:
            response.values = [self._node.get_parameter(name).get_parameter_value() for name in request.names]
        except (ParameterNotDeclaredException, ParameterUninitializedException):
            response.values = []
        return response

    def _get_parameter_types_callback(self, request: Any, response: Any) -> Any:
        try:
            response.types = self._node.get_parameter_types(request.names)
        except ParameterNotDeclaredException:
            response.types = []
        return response

    def _list_parameters_callback(self, request: Any, response: Any) -> Any:
        response.result = self._node.list_parameters(list(request.prefixes), request.depth)
        return response

    def _set_parameters_callback(self, request: Any, response: Any) -> Any:
        results = []
        for message in request.parameters:
            try:
                results += self._node.set_parameters([Parameter.from_parameter_msg(message)])
            except ParameterNotDeclaredException as error:
                results.append(_failure(error))
        response.results = results
        return response

    def _set_parameters_atomically_callback(self, request: Any, response: Any) -> Any:
        try:
            response.result = self._node.set_parameters_atomically(
                [Parameter.from_parameter_msg(message) for message in request.parameters]
            )
        except ParameterNotDeclaredException as error:
            response.result = _failure(error)
        return response


def _failure(error: Exception) -> Any:
    from rcl_interfaces.msg import SetParametersResult

    return SetParametersResult(successful=False, reason=str(error))


__getattr__ = passed_on(__name__)
