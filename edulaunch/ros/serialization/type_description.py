"""Type descriptions and their RIHS01 hashes, by which ROS 2 programs check whether they use the same definition of a type."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from edulaunch.engine.interfaces.services import event_of, feedback_message_of, get_result_of, send_goal_of
from edulaunch.engine.interfaces.spec import Field, FieldType, InterfaceSpec, MessageSpec, ServiceSpec

_NESTED_TYPE_ID = 1
_BOUNDED_STRING_IDS = {'string': 21, 'wstring': 22}
_ARRAY_OFFSETS = {'': 0, 'fixed': 48, 'bounded': 96, 'unbounded': 144}
# ROS adds this field to an interface without fields, because IDL allows no empty struct.
EMPTY_FIELD = Field('structure_needs_at_least_one_member', FieldType('uint8'))

SpecOf = Callable[[str], InterfaceSpec]


def type_description(type_name: str, spec_of: SpecOf) -> dict[str, Any]:
    """Return the description of a type and of all types in it, in the form of type_description_interfaces/msg/TypeDescription.

    :param spec_of: a function that returns the spec for a full type name (`Registry.spec`).
    """
    known: dict[str, dict[str, Any]] = {}
    waiting = [type_name]
    while waiting:
        name = waiting.pop()
        if name not in known:
            fields = _fields(spec_of(name))
            known[name] = {'type_name': name, 'fields': [_field(field) for field in fields]}
            waiting += [field.type.base for field in fields if field.type.kind is None]
    own = known.pop(type_name)
    return {'type_description': own, 'referenced_type_descriptions': [known[name] for name in sorted(known)]}


def type_hash(type_name: str, spec_of: SpecOf) -> str:
    """Return the hash of a type, such as 'RIHS01_df668c74...' for std_msgs/msg/String."""
    import json
    from hashlib import sha256

    return f'RIHS01_{sha256(json.dumps(type_description(type_name, spec_of)).encode()).hexdigest()}'


def _fields(spec: InterfaceSpec) -> tuple[Field, ...]:
    """Return the fields of a type. A service is described as a struct of its messages, and an action as a struct of its messages
    and services.
    """
    if isinstance(spec, MessageSpec):
        return spec.fields or (EMPTY_FIELD,)
    if isinstance(spec, ServiceSpec):
        parts = {
            'request_message': spec.request.type,
            'response_message': spec.response.type,
            'event_message': event_of(spec).type,
        }
    else:
        parts = {
            'goal': spec.goal.type,
            'result': spec.result.type,
            'feedback': spec.feedback.type,
            'send_goal_service': send_goal_of(spec).type,
            'get_result_service': get_result_of(spec).type,
            'feedback_message': feedback_message_of(spec).type,
        }
    return tuple(Field(name, FieldType(type_name)) for name, type_name in parts.items())


def _field(field: Field) -> dict[str, Any]:
    field_type, kind = field.type, field.type.kind
    if kind is None:
        type_id = _NESTED_TYPE_ID
    else:
        type_id = kind.type_id if field_type.string_bound is None else _BOUNDED_STRING_IDS[kind.name]
    return {
        'name': field.name,
        'type': {
            'type_id': type_id + _ARRAY_OFFSETS[field_type.array],
            'capacity': field_type.size,
            'string_capacity': field_type.string_bound or 0,
            'nested_type_name': field_type.base if kind is None else '',
        },
    }
