"""What is known about a refused assignment to a field, as plain data: what was given, and what to write."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from edulaunch.interfaces.message import Message
from edulaunch.interfaces.spec import FieldType

Facts = dict[str, Any]


def value_facts(field_type: FieldType, message: type[Message] | None, name: str, value: Any) -> Facts:
    """The facts of `messages.field-value`: `field`, `wanted`, `given`; and `write`, `fields`, `value` or `count` and `size`."""
    kind = field_type.kind
    wanted = message.__name__ if message is not None else kind.python.__name__ if kind is not None else 'str'
    facts = {'about': 'messages.field-value', 'field': name, 'wanted': wanted, 'given': given_kind(value)}
    if not field_type.array:
        return facts | _one(field_type, message, name, value)
    facts['wanted'] = f'{wanted}[]'
    if type(value).__module__ == 'numpy':
        return facts | _numpy(field_type, value)
    if not isinstance(value, Iterable):
        return facts | {'write': f'[{_brief(value)}]'}
    return facts if isinstance(value, (str, bytes)) else facts | _several(field_type, message, name, list(value))


def _numpy(field_type: FieldType, value: Any) -> Facts:
    kind = field_type.kind
    if getattr(value, 'ndim', 0) > 1:
        return {'write': 'value.ravel()'}
    if kind is not None and kind.is_number and getattr(value, 'ndim', 0) == 1:
        return {'given': f'{given_kind(value)}({value.dtype})', 'write': f"value.astype('{kind.name}')"}
    return {'write': 'value.tolist()'}


def _several(field_type: FieldType, message: type[Message] | None, name: str, values: list[Any]) -> Facts:
    kind = field_type.kind
    wanted = message or (kind.python if kind else object)
    for index, value in enumerate(values):
        if not isinstance(value, wanted):
            return value_facts(field_type.element, message, f'{name}[{index}]', value)
    if field_type.array != 'unbounded' and len(values) != field_type.size:
        return {'count': len(values), 'size': field_type.size}
    return {'value': _brief(values)}


def _one(field_type: FieldType, message: type[Message] | None, name: str, value: Any) -> Facts:
    kind = field_type.kind
    if message is not None:
        return {'fields': [f'{name}.{field}' for field in message._FIELDS]}
    if kind is None or isinstance(value, kind.python):
        return {'value': _brief(value)}
    if kind.python is float and type(value) is int:
        return {'write': f'{value}.0' if abs(value) < 10**15 else 'float(value)'}
    if kind.python is float and type(value) is tuple:
        return {'commas': len(value)}
    if kind.python is bytes:
        return {'write': f'bytes([{value}])'} if type(value) is int and 0 <= value < 256 else {}
    return {'write': f'{kind.python.__name__}(value)'} if _converts(kind.python, value) else {}


def _converts(python: type, value: Any) -> bool:
    try:
        python(value)
    except (TypeError, ValueError, OverflowError):
        return False
    return python is not bool or type(value).__module__ == 'numpy' or isinstance(value, int)


def given_kind(value: Any) -> str:
    """'int', 'numpy.float32', 'geometry_msgs.msg.Point', 'None'."""
    cls = type(value)
    if value is None:
        return 'None'
    if isinstance(value, Message):
        return str(cls.TYPE).replace('/', '.')
    return cls.__name__ if cls.__module__ == 'builtins' else f'{cls.__module__}.{cls.__name__}'


def _brief(value: Any) -> str:
    text = repr(value)
    return text if len(text) <= 60 else f'{text[:57]}...'
