"""The C structures and functions of rosidl and Fast CDR for type support, for ctypes.

The layouts are those of the headers that rosidl installs for generated code: `message_type_support_struct.h`,
`service_type_support_struct.h`, `action_type_support_struct.h`, `message_introspection.h`, `rosidl_typesupport_fastrtps_cpp`'s
`message_type_support.h` and the type descriptions of `rosidl_runtime_c`.
"""

from __future__ import annotations

import ctypes as c
from typing import Any

KEPT: list[object] = []
"""Objects to which C code has pointers. Types exist until the program ends."""


def keep(made: Any) -> Any:
    """Keep an object alive until the process ends, and return it."""
    KEPT.append(made)
    return made


def address_of(function: Any) -> int:
    """Return the address of a C function, or of a Python function that ctypes has made callable from C."""
    return c.cast(function, c.c_void_p).value or 0


class Block(c.Structure):
    """A message in C: its CDR bytes without the header, in memory from malloc."""

    _fields_ = (('data', c.c_void_p), ('size', c.c_size_t))


class Hash(c.Structure):
    """A RIHS hash: its version, and 32 bytes."""

    _fields_ = (('version', c.c_uint8), ('value', c.c_uint8 * 32))


class String(c.Structure):
    """A string of rosidl_runtime_c."""

    _fields_ = (('data', c.c_char_p), ('size', c.c_size_t), ('capacity', c.c_size_t))


class Sequence(c.Structure):
    """A sequence struct of rosidl_runtime_c, for any element type."""

    _fields_ = (('data', c.c_void_p), ('size', c.c_size_t), ('capacity', c.c_size_t))


class DescribedType(c.Structure):
    """The C struct of type_description_interfaces/FieldType."""

    _fields_ = (('type_id', c.c_uint8), ('capacity', c.c_uint64), ('string_capacity', c.c_uint64), ('nested', String))


class DescribedField(c.Structure):
    """The C struct of type_description_interfaces/Field."""

    _fields_ = (('name', String), ('type', DescribedType), ('default_value', String))


class DescribedOne(c.Structure):
    """The C struct of type_description_interfaces/IndividualTypeDescription."""

    _fields_ = (('type_name', String), ('fields', Sequence))


class Description(c.Structure):
    """The C struct of type_description_interfaces/TypeDescription."""

    _fields_ = (('type', DescribedOne), ('referenced', Sequence))


class TypeSource(c.Structure):
    """The C struct of type_description_interfaces/TypeSource."""

    _fields_ = (('type_name', String), ('encoding', String), ('contents', String))


_SUPPORT = (('identifier', c.c_void_p), ('data', c.c_void_p), ('function', c.c_void_p))
_DESCRIBED = (('hash', c.c_void_p), ('description', c.c_void_p), ('sources', c.c_void_p))


class MessageSupport(c.Structure):
    """The C struct rosidl_message_type_support_t."""

    _fields_ = (*_SUPPORT, *_DESCRIBED)


class ServiceSupport(c.Structure):
    """The C struct rosidl_service_type_support_t."""

    _fields_ = (
        *_SUPPORT,
        *((name, c.c_void_p) for name in ('request', 'response', 'event', 'create_event', 'destroy_event')),
        *_DESCRIBED,
    )


class ActionSupport(c.Structure):
    """The C struct rosidl_action_type_support_t."""

    _fields_ = (*((name, c.c_void_p) for name in ('goal', 'result', 'cancel', 'feedback', 'status')), *_DESCRIBED)


class MessageCallbacks(c.Structure):
    """The functions that rmw_fastrtps calls to convert a message to CDR and back."""

    _fields_ = (
        ('namespace', c.c_char_p),
        ('name', c.c_char_p),
        *((name, c.c_void_p) for name in ('serialize', 'deserialize', 'size', 'largest_size', 'key')),
    )


class ServiceCallbacks(c.Structure):
    """The names of a service, and the type support of its request and its response."""

    _fields_ = (('namespace', c.c_char_p), ('name', c.c_char_p), ('request', c.c_void_p), ('response', c.c_void_p))


class Member(c.Structure):
    """A field of a message, for introspection."""

    _fields_ = (
        ('name', c.c_char_p),
        ('type_id', c.c_uint8),
        ('string_bound', c.c_size_t),
        ('nested', c.c_void_p),
        ('is_key', c.c_bool),
        ('is_array', c.c_bool),
        ('array_size', c.c_size_t),
        ('is_upper_bound', c.c_bool),
        ('offset', c.c_uint32),
        ('default', c.c_void_p),
        *((f'function{number}', c.c_void_p) for number in range(6)),
    )


class Members(c.Structure):
    """The fields of a message, for introspection."""

    _fields_ = (
        ('namespace', c.c_char_p),
        ('name', c.c_char_p),
        ('count', c.c_uint32),
        ('size', c.c_size_t),
        ('has_key', c.c_bool),
        ('members', c.c_void_p),
        ('begin', c.c_void_p),
        ('end', c.c_void_p),
    )


class ServiceMembers(c.Structure):
    """The request, the response and the event message of a service, for introspection."""

    _fields_ = (
        ('namespace', c.c_char_p),
        ('name', c.c_char_p),
        ('request', c.c_void_p),
        ('response', c.c_void_p),
        ('event', c.c_void_p),
    )


TO_SUPPORT = c.CFUNCTYPE(c.c_void_p, c.c_void_p, c.c_char_p)
"""The type of a C function that returns the variant of a type support for an identifier."""
GIVES_ADDRESS = c.CFUNCTYPE(c.c_void_p, c.c_void_p)

libc = c.CDLL(None)
libc.malloc.restype, libc.malloc.argtypes = c.c_void_p, (c.c_size_t,)
libc.calloc.restype, libc.calloc.argtypes = c.c_void_p, (c.c_size_t, c.c_size_t)
libc.free.restype, libc.free.argtypes = None, (c.c_void_p,)

runtime = c.CDLL('librosidl_runtime_c.so')
_fastrtps = c.CDLL('librosidl_typesupport_fastrtps_c.so')
_introspection = c.CDLL('librosidl_typesupport_introspection_c.so')
FASTRTPS = c.c_char_p.in_dll(_fastrtps, 'rosidl_typesupport_fastrtps_c__identifier')
INTROSPECTION = c.c_char_p.in_dll(_introspection, 'rosidl_typesupport_introspection_c__identifier')
NO_VARIANTS = {
    'message': address_of(runtime.get_message_typesupport_handle_function),
    'service': address_of(runtime.get_service_typesupport_handle_function),
}
"""The C functions for type supports of a single kind. Each returns the type support itself if this kind is requested."""


def identifier(of: c.c_char_p) -> int:
    """Return the address of an identifier's string."""
    return c.cast(of, c.c_void_p).value or 0


def chooser(fast: Any, introspected: Any) -> int:
    """Return a C function that returns the requested variant of a type support."""
    known = {FASTRTPS.value: c.addressof(fast), INTROSPECTION.value: c.addressof(introspected)}
    return address_of(keep(TO_SUPPORT(lambda support, wanted: known.get(wanted))))


_new_capsule = c.pythonapi.PyCapsule_New
_new_capsule.restype, _new_capsule.argtypes = c.py_object, (c.c_void_p, c.c_char_p, c.c_void_p)
_in_capsule = c.pythonapi.PyCapsule_GetPointer
_in_capsule.restype, _in_capsule.argtypes = c.c_void_p, (c.py_object, c.c_char_p)


def capsule(address: int) -> object:
    """Return a capsule around an address, in the form that rclpy reads from a class."""
    made: object = _new_capsule(address, None, None)
    return made


def capsule_address(made: object) -> int:
    """Return the address in a capsule."""
    return int(_in_capsule(made, None))
