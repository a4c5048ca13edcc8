"""The service by which others learn what the types look like that a node uses."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from rclpy.exceptions import ParameterUninitializedException
from rclpy.impl.passed_on import passed_on
from rclpy.parameter import ParameterType
from rclpy.qos import qos_profile_services_default

if TYPE_CHECKING:
    from rclpy.node import Node

START_TYPE_DESCRIPTION_SERVICE_PARAM = 'start_type_description_service'


class TypeDescriptionService:
    """Declares start_type_description_service (read-only) and, unless it is false, makes `<node>/get_type_description`."""

    def __init__(self, node: Node) -> None:
        from rcl_interfaces.msg import ParameterDescriptor

        self._node = node
        descriptor = ParameterDescriptor(
            name=START_TYPE_DESCRIPTION_SERVICE_PARAM,
            type=ParameterType.BOOL.value,
            read_only=True,
            description='If enabled, start the ~/get_type_description service.',
        )
        if not node.has_parameter(START_TYPE_DESCRIPTION_SERVICE_PARAM):
            node.declare_parameter(START_TYPE_DESCRIPTION_SERVICE_PARAM, True, descriptor)
        try:
            enabled = node.get_parameter(START_TYPE_DESCRIPTION_SERVICE_PARAM).value
        except ParameterUninitializedException:
            enabled = False
        if enabled:
            from type_description_interfaces.srv import GetTypeDescription

            node.create_service(
                GetTypeDescription,
                f'{node.get_name()}/get_type_description',
                self._answer,
                qos_profile=qos_profile_services_default,
            )

    def _answer(self, request: Any, response: Any) -> Any:
        from edulaunch.interfaces import current_registry
        from edulaunch.interfaces.description import type_description, type_hash

        known = {end.type_name for end in self._node._rclpy.entry.endpoints}
        if request.type_name not in known:
            response.failure_reason = f"Type '{request.type_name}' is not currently in use by this node"
            return response
        spec_of = current_registry().spec
        actual = type_hash(request.type_name, spec_of)
        if request.type_hash and request.type_hash != actual:
            response.failure_reason = (
                f'Type {request.type_name} exists, but with hash {actual} and not the requested {request.type_hash}'
            )
            return response
        description = type_description(request.type_name, spec_of)
        target = response.type_description
        target.type_description = _individual(description['type_description'])
        target.referenced_type_descriptions = [_individual(one) for one in description['referenced_type_descriptions']]
        response.successful = True
        return response


def _individual(description: dict[str, Any]) -> Any:
    from type_description_interfaces.msg import Field, FieldType, IndividualTypeDescription

    fields = []
    for field in description['fields']:
        kind = dict(field['type'])
        fields.append(Field(name=field['name'], default_value=field.get('default_value', ''), type=FieldType(**kind)))
    return IndividualTypeDescription(type_name=description['type_name'], fields=fields)


__getattr__ = passed_on(
    __name__,
    {
        'type_description_interfaces.srv': 'GetTypeDescription',
        'rclpy.parameter': 'Parameter',
        'rcl_interfaces.msg': 'ParameterDescriptor',
        'rclpy.service': 'Service',
        'rclpy.type_support': 'check_is_valid_srv_type',
    },
)
