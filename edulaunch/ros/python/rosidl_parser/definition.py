"""The types of fields that the `SLOT_TYPES` of a message class contain."""

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
