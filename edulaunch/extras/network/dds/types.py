"""The types of ROS 2 messages for cyclonedds, generated at run time from their definitions.

Peers that compare types (XTypes) thus find equal types. edulaunch's own codec writes the bytes of messages.
"""

from __future__ import annotations

from functools import lru_cache
from typing import TYPE_CHECKING, Any

from cyclonedds.idl import IdlMeta, IdlStruct
from cyclonedds.idl import types as idl

from edulaunch.extras.network.dds.mangling import dds_type
from edulaunch.ros.serialization.type_description import EMPTY_FIELD

if TYPE_CHECKING:
    from edulaunch.engine.interfaces.registry import Registry
    from edulaunch.engine.interfaces.spec import FieldType, MessageSpec

PRIMITIVES: dict[str, Any] = {
    'bool': bool,
    'byte': idl.uint8,
    'string': str,
    'wstring': idl.sequence[idl.uint32],  # IDL for Python has no wstring; these are its bytes
    **{name: getattr(idl, name) for name in ('uint8', 'int8', 'uint16', 'int16', 'uint32', 'int32', 'uint64', 'int64')},
    **{name: getattr(idl, name) for name in ('float32', 'float64')},
}
TAKEN = ('serialize', 'deserialize', 'serialize_key', 'deserialize_key')
"""The types that have another name in IdlStruct."""


CALL = {'client_guid': idl.uint64, 'sequence_number': idl.int64}
"""The fields that Cyclone DDS puts before a request and a reply."""


@lru_cache(maxsize=1024)
def idl_class(type_name: str, registry: Registry, is_call: bool = False) -> Any:
    """Return the IdlStruct with the fields of a message type.

    :param is_call: whether the type is a request or a reply, which begins with the ID of the call.
    :raises InterfaceError: when there is no such type.
    """
    spec: MessageSpec = registry.spec(type_name)  # type: ignore[assignment]
    name = type_name.rpartition('/')[2]
    namespace = IdlMeta.__prepare__(name, (IdlStruct,), typename=dds_type(type_name))
    namespace['__module__'] = __name__
    namespace['__annotations__'].update(CALL if is_call else {})
    for field in spec.fields or (EMPTY_FIELD,):
        namespace['__annotations__'][field.name + '_' * (field.name in TAKEN)] = _type(field.type, registry)
    return IdlMeta(name, (IdlStruct,), namespace)


def _type(field: FieldType, registry: Registry) -> Any:
    if field.kind is None:
        one = idl_class(field.base, registry)
    else:
        bounded = field.string_bound is not None and field.base == 'string'
        one = idl.bounded_str[field.string_bound] if bounded else PRIMITIVES[field.base]
    if not field.array:
        return one
    if field.array == 'unbounded':
        return idl.sequence[one]
    return (idl.array if field.array == 'fixed' else idl.sequence)[one, field.size]
