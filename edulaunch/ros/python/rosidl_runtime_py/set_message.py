"""Sets fields of messages from dictionaries."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from edulaunch.engine.interfaces.message import rules_of, spec_of

HEADER, TIME = 'std_msgs/msg/Header', 'builtin_interfaces/msg/Time'


def set_message_fields(
    msg: Any, values: Mapping[str, Any], expand_header_auto: bool = False, expand_time_now: bool = False
) -> list[Any]:
    """Set the fields in `values`. Each value is converted to its field's type: 3 and '3' become 3.0 in a float field.

    :param msg: the message, which is changed in place.
    :param values: the value of each field by name; dictionaries for nested messages, lists for arrays.
    :param expand_header_auto: whether 'auto' for a header means a header whose stamp is set later.
    :param expand_time_now: whether 'now' for a time means a time that is set later.
    :returns: a function for each time to set later. Its argument is the Time to set.
    :raises TypeError: when `values` is not a dictionary.
    :raises AttributeError: when the message has no field of that name.
    :raises ValueError: when a value cannot be converted.
    """
    if not isinstance(values, Mapping):
        raise TypeError(f"Value '{values}' is expected to be a dictionary but is a {type(values).__name__}")
    stamps: list[Any] = []
    fields = {field.name: field.type for field in spec_of(msg).fields}
    for name, value in values.items():
        field_type = fields.get(name)
        if field_type is None:
            setattr(msg, name, value)  # for a constant or a misspelt field, the message raises its own error
        elif expand_header_auto and field_type.text in (HEADER, 'std_msgs/Header') and value == 'auto':
            stamps.append(_setter(getattr(msg, name), 'stamp'))
        elif expand_time_now and field_type.base == TIME and not field_type.array and value == 'now':
            stamps.append(_setter(msg, name))
        elif field_type.kind is None:
            stamps += _set_nested(msg, name, field_type, value, (expand_header_auto, expand_time_now))
        else:
            setattr(msg, name, _converted(getattr(msg, name), field_type, value))
    return stamps


def _setter(message: Any, name: str) -> Any:
    return lambda now: setattr(message, name, now)


def _set_nested(msg: Any, name: str, field_type: Any, value: Any, expand: tuple[bool, bool]) -> list[Any]:
    """Set a field that contains messages. The value contains messages, or dictionaries of their fields."""
    cls = rules_of(msg)[name].message
    if not field_type.array:
        if isinstance(value, cls):
            setattr(msg, name, value)
            return []
        fresh = cls()
        setattr(msg, name, fresh)
        return set_message_fields(fresh, value, *expand)
    made, stamps = [], []
    for item in value:
        made.append(item if isinstance(item, cls) else cls())
        if made[-1] is not item:
            stamps += set_message_fields(made[-1], item, *expand)
    setattr(msg, name, made)
    return stamps


def _converted(present: Any, field_type: Any, value: Any) -> Any:
    if not field_type.array:
        python = field_type.kind.python
        return value if type(value) is python else bytes([value]) if python is bytes else python(value)
    if hasattr(present, 'typecode'):
        return type(present)(present.typecode, value)
    return value.__class__(value) if not hasattr(present, 'dtype') else _array(present, value)


def _array(present: Any, value: Any) -> Any:
    import numpy

    return numpy.array(value, dtype=present.dtype)
