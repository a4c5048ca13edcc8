"""How a message lies flat in a wire tuple.

A wire tuple holds the message's single values in order, with the fields of nested messages in place of the nested message:
a Twist is `(linear.x, linear.y, linear.z, angular.x, angular.y, angular.z)`. Only repeated fields are tuples (or bytes) inside it;
each element of a repeated message field is such a flat tuple again.
"""
from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

from edulaunch.interfaces.kinds import BYTE_LIKE
from edulaunch.interfaces.spec import Field, FieldType, MessageSpec

SpecOf = Callable[[str], MessageSpec]


class Branch(NamedTuple):
    """A nested message: the variable that holds it in generated code, and the slot of its holder."""

    variable: str
    holder: str
    slot: str
    type: str


class Leaf(NamedTuple):
    """One entry of the wire tuple: its dotted path, and where the object tree keeps it."""

    path: str
    target: str
    field: Field

    @property
    def type(self) -> FieldType:
        """The field's type."""
        return self.field.type


class Layout(NamedTuple):
    """The branches (outer before inner) and the leaves (in wire order) of one message."""

    branches: tuple[Branch, ...]
    leaves: tuple[Leaf, ...]


def layout_of(spec: MessageSpec, spec_of: SpecOf) -> Layout:
    """The flat layout of a message; `spec_of` gives the spec of a nested type."""
    branches: list[Branch] = []
    leaves: list[Leaf] = []

    def visit(message: MessageSpec, variable: str, prefix: str) -> None:
        for field in message.fields:
            slot, path = f'_{field.name}', f'{prefix}{field.name}'
            if field.type.kind is None and not field.type.array:
                branch = Branch(f'b{len(branches)}', variable, slot, field.type.base)
                branches.append(branch)
                visit(spec_of(field.type.base), branch.variable, f'{path}.')
            else:
                leaves.append(Leaf(path, f'{variable}.{slot}', field))

    visit(spec, 'm', '')
    return Layout(tuple(branches), tuple(leaves))


def is_byte_like(field_type: FieldType) -> bool:
    """Whether a repeated field travels as one bytes object."""
    return bool(field_type.array) and field_type.base in BYTE_LIKE


def is_fixed_numbers(field_type: FieldType) -> bool:
    """Whether the field is a numpy array to its reader."""
    return field_type.array == 'fixed' and field_type.kind is not None and field_type.kind.is_number


def is_number_sequence(field_type: FieldType) -> bool:
    """Whether the field is an array.array to its reader."""
    return field_type.array in ('bounded', 'unbounded') and field_type.kind is not None and field_type.kind.is_number


def zero(field_type: FieldType) -> Any:
    """The value of one element that was never set."""
    kind = field_type.kind
    assert kind is not None
    return b'\x00' if kind.python is bytes else kind.python()


def default_wire(field: Field) -> Any:
    """The wire value of a field that was never set."""
    field_type = field.type
    if not field_type.array:
        return zero(field_type) if field.default is None else field.default
    values = field.default
    if values is None:
        if field_type.kind is None:
            raise ValueError('the elements of a nested field have no plain default')
        values = (zero(field_type),) * (field_type.size if field_type.array == 'fixed' else 0)
    return _as_bytes(field_type, values) if is_byte_like(field_type) else tuple(values)


def _as_bytes(field_type: FieldType, values: tuple[Any, ...]) -> bytes:
    return b''.join(values) if field_type.base == 'byte' else bytes(value & 255 for value in values)
