"""The entries of `SLOT_TYPES`, with the names of rosidl_parser.definition."""

from __future__ import annotations

from typing import NamedTuple

from edulaunch.engine.interfaces.spec import FieldType, MessageSpec


class BasicType(NamedTuple):
    """A number, boolean or octet."""

    typename: str


class UnboundedString(NamedTuple):
    """`string`."""


class BoundedString(NamedTuple):
    """`string<=N`."""

    maximum_size: int


class UnboundedWString(NamedTuple):
    """`wstring`."""


class BoundedWString(NamedTuple):
    """`wstring<=N`."""

    maximum_size: int


class NamespacedType(NamedTuple):
    """Another interface: namespaces ('geometry_msgs', 'msg') and name 'Point'."""

    namespaces: tuple[str, ...]
    name: str


class Array(NamedTuple):
    """`T[N]`."""

    value_type: object
    size: int


class BoundedSequence(NamedTuple):
    """`T[<=N]`."""

    value_type: object
    maximum_size: int


class UnboundedSequence(NamedTuple):
    """`T[]`."""

    value_type: object


def slot_types(spec: MessageSpec) -> tuple[object, ...]:
    """Return one entry for each field, in order."""
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
