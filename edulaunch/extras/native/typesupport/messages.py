"""Type support for message classes."""

from __future__ import annotations

import ctypes as c
from typing import Any

from edulaunch.engine.interfaces.message import Message
from edulaunch.engine.interfaces.registry import Registry
from edulaunch.extras.native.typesupport import abi, cdr_block
from edulaunch.extras.native.typesupport.description import described
from edulaunch.ros.serialization.cdr import HEADER, decode, encode
from edulaunch.ros.serialization.type_description import EMPTY_FIELD

_KIND_NUMBERS = {
    'float32': 1,
    'float64': 2,
    'bool': 6,
    'byte': 7,
    'uint8': 8,
    'int8': 9,
    'uint16': 10,
    'int16': 11,
    'uint32': 12,
    'int32': 13,
    'uint64': 14,
    'int64': 15,
    'string': 16,
    'wstring': 17,
}
_NESTED_NUMBER = 18


def support_message(cls: type[Message], registry: Registry) -> type[Message]:
    """Put type support on the metaclass of a message class, where the real rclpy finds it. Create it on first use."""
    names = ('_TYPE_SUPPORT', '_CREATE_ROS_MESSAGE', '_DESTROY_ROS_MESSAGE', '_CONVERT_FROM_PY', '_CONVERT_TO_PY')
    metaclass: Any = type(f'Metaclass_{cls.__name__}', (type(cls),), dict.fromkeys(names))

    def import_type_support(_: type) -> None:
        if metaclass._TYPE_SUPPORT is None:
            functions = (cdr_block.CREATE, cdr_block.DESTROY, _from_python(cls), _to_python(cls))
            for name, address in zip(names, (c.addressof(message_support(cls, registry)), *functions), strict=True):
                setattr(metaclass, name, abi.capsule(address))

    metaclass.__import_type_support__ = classmethod(import_type_support)
    cls.__class__ = metaclass  # type: ignore[method-assign]
    return cls


def _from_python(cls: type[Message]) -> int:
    fill, to_wire = cdr_block.fill, cls.to_wire

    def convert(message: Message, block: int) -> bool:
        fill(block, encode(cls, to_wire(message))[4:])
        return True

    return abi.address_of(abi.keep(c.PYFUNCTYPE(c.c_bool, c.py_object, c.c_void_p)(convert)))


def _to_python(cls: type[Message]) -> int:
    content, from_wire = cdr_block.content, cls.from_wire

    def convert(block: int) -> Any:
        return from_wire(decode(cls, HEADER + content(block)))

    return abi.address_of(abi.keep(c.PYFUNCTYPE(c.py_object, c.c_void_p)(convert)))


def message_support(cls: type[Message], registry: Registry) -> abi.MessageSupport:
    """Return the C type support of a message class. Create it only once."""
    made = cls.__dict__.get('_NATIVE_SUPPORT')
    if made is None:
        package, kind, name = cls.TYPE.split('/')
        functions = (cdr_block.SERIALIZE, cdr_block.DESERIALIZE, cdr_block.SIZE, cdr_block.LARGEST_SIZE)
        callbacks = abi.keep(abi.MessageCallbacks(f'{package}::{kind}'.encode(), name.encode(), *functions, None))
        made = abi.keep(abi.MessageSupport(abi.identifier(abi.FASTRTPS), c.addressof(callbacks)))
        made.function = abi.chooser(made, introspection(cls, registry))
        made.hash, made.description, made.sources = described(cls.TYPE, registry)
        type.__setattr__(cls, '_NATIVE_SUPPORT', made)
    return made  # type: ignore[no-any-return]


def introspection(cls: type[Message], registry: Registry) -> abi.MessageSupport:
    """Return the C type support with which C code reads the fields of a message class. Create it only once."""
    made = cls.__dict__.get('_NATIVE_INTROSPECTION')
    if made is None:
        where = c.addressof(members(cls, registry))
        made = abi.keep(abi.MessageSupport(abi.identifier(abi.INTROSPECTION), where, abi.NO_VARIANTS['message']))
        type.__setattr__(cls, '_NATIVE_INTROSPECTION', made)
    return made  # type: ignore[no-any-return]


def members(cls: type[Message], registry: Registry) -> abi.Members:
    """Return the fields of a message class in C form. Create them only once."""
    made = cls.__dict__.get('_NATIVE_MEMBERS')
    if made is None:
        fields = cls._SPEC.fields or (EMPTY_FIELD,)
        rows = abi.keep((abi.Member * len(fields))(*(_member(field, registry) for field in fields)))
        package, kind, name = cls.TYPE.split('/')
        made = abi.keep(
            abi.Members(f'{package}__{kind}'.encode(), name.encode(), len(rows), c.sizeof(abi.Block), False, c.addressof(rows))
        )
        type.__setattr__(cls, '_NATIVE_MEMBERS', made)
    return made  # type: ignore[no-any-return]


def _member(field: Any, registry: Registry) -> abi.Member:
    kind = field.type
    row = abi.Member(name=field.name.encode(), type_id=_KIND_NUMBERS.get(kind.base, _NESTED_NUMBER))
    row.string_bound = kind.string_bound or 0
    row.is_array, row.array_size, row.is_upper_bound = kind.array != '', kind.size, kind.array == 'bounded'
    if kind.kind is None:
        row.nested = c.addressof(introspection(registry.get(kind.base), registry))
    return row
