"""The entries of `SLOT_TYPES`. The classes have the same names as in rosidl_parser.definition."""

from __future__ import annotations

from typing import NamedTuple

from edulaunch.engine.interfaces.spec import FieldType, MessageSpec


class BasicType(NamedTuple):
    """A number, boolean or octet."""

    typename: str


class UnboundedString(NamedTuple):
    """The type `string`."""


class BoundedString(NamedTuple):
    """The type `string<=N`."""

    maximum_size: int


class UnboundedWString(NamedTuple):
    """The type `wstring`."""


class BoundedWString(NamedTuple):
    """The type `wstring<=N`."""

    maximum_size: int


class NamespacedType(NamedTuple):
    """The type of another interface, such as ('geometry_msgs', 'msg') as namespaces and 'Point' as name."""

    namespaces: tuple[str, ...]
    name: str


class Array(NamedTuple):
    """The type `T[N]`."""

    value_type: object
    size: int


class BoundedSequence(NamedTuple):
    """The type `T[<=N]`."""

    value_type: object
    maximum_size: int


class UnboundedSequence(NamedTuple):
    """The type `T[]`."""

    value_type: object


def slot_types(spec: MessageSpec) -> tuple[object, ...]:
    """Return the `SLOT_TYPES` of a message: one entry for each field, in order."""
    return tuple(_slot_type(field.type) for field in spec.fields)


def _slot_type(field_type: FieldType) -> object:
    if field_type.array == 'fixed':
        return Array(_one(field_type), field_type.size)
    if field_type.array == 'bounded':
        return BoundedSequence(_one(field_type), field_type.size)
    return UnboundedSequence(_one(field_type)) if field_type.array else _one(field_type)


def _one(field_type: FieldType) -> object:
    kind = field_type.kind
    if kind is None:
        *namespaces, name = field_type.base.split('/')
        return NamespacedType(tuple(namespaces), name)
    bound = field_type.string_bound
    if kind.name == 'string':
        return UnboundedString() if bound is None else BoundedString(bound)
    if kind.name == 'wstring':
        return UnboundedWString() if bound is None else BoundedWString(bound)
    return BasicType(kind.ros)
