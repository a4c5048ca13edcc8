"""The service from which other nodes request the definitions of the types that a node uses."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Any

from edulaunch.engine.interfaces import current_registry
from edulaunch.ros.passed_on import passed_on
from rclpy.exceptions import ParameterUninitializedException
from rclpy.logging import get_logger
from rclpy.node_parts.core import core_of
from rclpy.parameter import Parameter
from rclpy.qos import qos_profile_services_default

if TYPE_CHECKING:
    from edulaunch.engine.interfaces.registry import Registry
    from rclpy.impl.protocols import NodeProtocol

START_TYPE_DESCRIPTION_SERVICE_PARAM = 'start_type_description_service'


class TypeDescriptionService:
    """Declares the read-only parameter start_type_description_service, and creates `<node>/get_type_description` unless it is
    false.
    """

    def __init__(self, node: NodeProtocol) -> None:
        from rcl_interfaces.msg import ParameterDescriptor

        self._node = node
        descriptor = ParameterDescriptor(
            name=START_TYPE_DESCRIPTION_SERVICE_PARAM,
            type=Parameter.Type.BOOL.value,
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
        from edulaunch.ros.serialization.type_description import type_description, type_hash

        if not re.fullmatch('RIHS01_[0-9a-f]{64}', request.type_hash):
            get_logger('rcl').error(f"Failed to parse type hash '{request.type_hash}'")
            response.failure_reason = 'Failed to parse type hash'
            return response
        registry = current_registry()
        in_use = sorted({end.type_name for end in core_of(self._node).entry.endpoints})
        found = [name for name in in_use if type_hash(name, registry.spec) == request.type_hash]
        if not found:
            response.failure_reason = 'Type not currently in use by this node'
            return response
        spec_of = registry.spec
        description = type_description(found[0], spec_of)  # the hash alone identifies the type, as in rcl
        target = response.type_description
        target.type_description = _individual(description['type_description'])
        target.referenced_type_descriptions = [_individual(one) for one in description['referenced_type_descriptions']]
        if request.include_type_sources:
            described = (target.type_description, *target.referenced_type_descriptions)
            response.type_sources = [_source(one.type_name, registry) for one in described]
        response.successful = True
        return response


def _source(type_name: str, registry: Registry) -> Any:
    from type_description_interfaces.msg import TypeSource

    return TypeSource(type_name=type_name, encoding=type_name.split('/')[1], raw_file_contents=registry.text(type_name))


def _individual(description: dict[str, Any]) -> Any:
    from type_description_interfaces.msg import Field, FieldType, IndividualTypeDescription

    fields = []
    for field in description['fields']:
        kind = dict(field['type'])
        fields.append(Field(name=field['name'], default_value=field.get('default_value', ''), type=FieldType(**kind)))
    return IndividualTypeDescription(type_name=description['type_name'], fields=fields)


__getattr__ = passed_on(__name__)
