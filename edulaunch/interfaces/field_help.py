"""The line of help under a refused assignment."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from edulaunch.interfaces.message import Message
from edulaunch.interfaces.spec import FieldType


def help_for(field_type: FieldType, message: type[Message] | None, name: str, value: Any) -> str:
    """What was given instead, and what to write."""
    if not field_type.array:
        return _one(field_type, message, name, value)
    if type(value).__module__ == 'numpy':
        return _numpy(field_type, value)
    if not isinstance(value, Iterable):
        return f'{_given(value)} was given: write [{_brief(value)}]'
    if isinstance(value, (str, bytes)):
        return f'{_given(value)} was given'
    return _several(field_type, message, name, list(value))


def _numpy(field_type: FieldType, value: Any) -> str:
    kind, given = field_type.kind, f'{_given(value)} was given'
    if getattr(value, 'ndim', 0) > 1:
        return f'{given} with {value.ndim} dimensions: write value.ravel()'
    if kind is not None and kind.is_number and getattr(value, 'ndim', 0) == 1:
        return f"{given} of '{value.dtype}': write value.astype('{kind.name}')"
    return f'{given}: write value.tolist()'


def _several(field_type: FieldType, message: type[Message] | None, name: str, values: list[Any]) -> str:
    kind = field_type.kind
    wanted = message or (kind.python if kind else object)
    for index, value in enumerate(values):
        if not isinstance(value, wanted):
            return _one(field_type.element, message, f'{name}[{index}]', value).replace(' was given', f' is at index {index}', 1)
    if field_type.array != 'unbounded' and len(values) != field_type.size:
        return f'{len(values)} value{"s" * (len(values) != 1)} given'
    return 'a value is out of range'


def _one(field_type: FieldType, message: type[Message] | None, name: str, value: Any) -> str:
    kind = field_type.kind
    given = f'{_given(value)} was given'
    if message is not None:
        fields = ', '.join(f'{name}.{field}' for field in message._FIELDS)
        return f'{given}: set its fields ({fields}) or assign a {message.__name__}(...)' if fields else given
    if kind is None or isinstance(value, kind.python):
        return f'{_brief(value)} was given'
    if kind.python is float and type(value) is int:
        return f'{given}: write {value}.0' if abs(value) < 10**15 else f'{given}: write float(value)'
    if kind.python is bytes:
        return f'{given}: write bytes([{value}])' if type(value) is int and 0 <= value < 256 else given
    if _converts(kind.python, value):
        return f'{given}: write {kind.python.__name__}(value)'
    return given


def _converts(python: type, value: Any) -> bool:
    try:
        python(value)
    except (TypeError, ValueError, OverflowError):
        return False
    return python is not bool or type(value).__module__ == 'numpy' or isinstance(value, int)


def _given(value: Any) -> str:
    cls = type(value)
    if value is None:
        return 'None'
    if isinstance(value, Message):
        package, kind, name = cls.TYPE.split('/')
        return f'a {package}.{kind}.{name}'
    name = cls.__name__ if cls.__module__ == 'builtins' else f'{cls.__module__}.{cls.__name__}'
    return f'{"an" if name[0] in "aeiou" else "a"} {name}'


def _brief(value: Any) -> str:
    text = repr(value)
    return text if len(text) <= 60 else f'{text[:57]}...'
