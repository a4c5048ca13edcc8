"""The types of fields, as in `SLOT_TYPES` of a message class."""

from edulaunch.engine.interfaces.slot_types import (
    Array,
    BasicType,
    BoundedSequence,
    BoundedString,
    BoundedWString,
    NamespacedType,
    UnboundedSequence,
    UnboundedString,
    UnboundedWString,
)

__all__ = [
    'Array',
    'BasicType',
    'BoundedSequence',
    'BoundedString',
    'BoundedWString',
    'NamespacedType',
    'UnboundedSequence',
    'UnboundedString',
    'UnboundedWString',
]
