"""The layout of a message in a flat wire tuple.

A wire tuple contains the single values of a message in order. The values of a nested message are inserted at the place of the
nested message. A Twist is `(linear.x, linear.y, linear.z, angular.x, angular.y, angular.z)`. Only repeated fields are tuples (or
bytes) inside it. Each element of a repeated message field is again a flat tuple.
"""

from __future__ import annotations

from array import array
from collections.abc import Callable
from typing import Any

from edulaunch.engine.interfaces.spec import BYTE_LIKE, Field, FieldType, MessageSpec

SpecOf = Callable[[str], MessageSpec]


class Branch:
    """A nested message: its variable in generated code, the variable of the outer message and the slot there, and its type."""

    __slots__ = ('variable', 'holder', 'slot', 'type')

    def __init__(self, variable: str, holder: str, slot: str, type_name: str) -> None:
        self.variable = variable
        self.holder = holder
        self.slot = slot
        self.type = type_name


class Leaf:
    """One entry of the wire tuple: its dotted path, the variable and the type of the message that has the field, and the
    field.
    """

    __slots__ = ('path', 'holder', 'owner', 'field', 'type')

    def __init__(self, path: str, holder: str, owner: str, field: Field) -> None:
        self.path = path
        self.holder = holder
        self.owner = owner
        self.field = field
        self.type = field.type

    @property
    def target(self) -> str:
        """The expression for the slot in generated code."""
        return f'{self.holder}._{self.field.name}'

    def held_by(self, variable: str) -> Leaf:
        """Return the same leaf for a message that is in another variable."""
        return Leaf(self.path, variable, self.owner, self.field)


class Layout:
    """The branches (outer before inner) and the leaves (in wire order) of one message."""

    __slots__ = ('branches', 'leaves')

    def __init__(self, branches: tuple[Branch, ...], leaves: tuple[Leaf, ...]) -> None:
        self.branches = branches
        self.leaves = leaves


def layout_of(spec: MessageSpec, spec_of: SpecOf) -> Layout:
    """Return the flat layout of a message.

    :param spec: the definition of the message.
    :param spec_of: a function that returns the spec of a nested type.
    """
    branches: list[Branch] = []
    leaves: list[Leaf] = []

    def visit(message: MessageSpec, variable: str, prefix: str) -> None:
        for field in message.fields:
            path = f'{prefix}{field.name}'
            if field.type.kind is None and not field.type.array:
                branch = Branch(f'b{len(branches)}', variable, f'_{field.name}', field.type.base)
                branches.append(branch)
                visit(spec_of(field.type.base), branch.variable, f'{path}.')
            else:
                leaves.append(Leaf(path, variable, message.type, field))

    visit(spec, 'm', '')
    return Layout(tuple(branches), tuple(leaves))


def is_byte_like(field_type: FieldType) -> bool:
    """Return whether a repeated field is a bytes object in the wire tuple."""
    return bool(field_type.array) and field_type.base in BYTE_LIKE


def is_fixed_numbers(field_type: FieldType) -> bool:
    """Return whether a program that reads the field gets a numpy array."""
    return field_type.array == 'fixed' and field_type.kind is not None and field_type.kind.is_number


def is_number_sequence(field_type: FieldType) -> bool:
    """Return whether a program that reads the field gets an `array.array`."""
    return field_type.array in ('bounded', 'unbounded') and field_type.kind is not None and field_type.kind.is_number


def zero(field_type: FieldType) -> Any:
    """Return the value of one element that was never set."""
    kind = field_type.kind
    assert kind is not None
    return b'\x00' if kind.python is bytes else kind.python()


def default_wire(field: Field) -> Any:
    """Return the wire value of a field that was never set."""
    field_type = field.type
    if not field_type.array:
        return zero(field_type) if field.default is None else field.default
    values = field.default
    if values is None:
        if field_type.kind is None:
            raise ValueError('the elements of a nested field have no plain default')
        values = (zero(field_type),) * (field_type.size if field_type.array == 'fixed' else 0)
    if field_type.base == 'float32':
        values = array('f', values)  # round to float32, as numpy does; a single float32 keeps its value until it is sent
    return _as_bytes(field_type, values) if is_byte_like(field_type) else tuple(values)


def _as_bytes(field_type: FieldType, values: tuple[Any, ...]) -> bytes:
    return b''.join(values) if field_type.base == 'byte' else bytes(value & 255 for value in values)
