"""Values written in interface texts: constants and defaults."""

from __future__ import annotations

import re
from typing import Any

from edulaunch.interfaces.kinds import KINDS, primitive_name
from edulaunch.interfaces.spec import FieldType


def constant_value(base: str, text: str) -> Any:
    """The value of a constant. A string may stand without quotes, as ROS allows.

    :raises ValueError: naming what was expected.
    """
    if base in ('string', 'wstring'):
        return _string(text, None)
    return _scalar(FieldType(primitive_name(base)), text)


def default_value(field_type: FieldType, text: str) -> Any:
    """The default of a field: a scalar, or a tuple for `[1, 2, 3]`.

    :raises ValueError: naming what was expected.
    """
    if not field_type.array:
        return _scalar(field_type, text)
    if not (text.startswith('[') and text.endswith(']')):
        raise ValueError(f'a list in brackets such as [1, 2], not {text}')
    values = tuple(_scalar(field_type.element, item) for item in _items(text[1:-1]))
    wanted = field_type.size
    if field_type.array == 'fixed' and len(values) != wanted:
        raise ValueError(f'{wanted} values, not {len(values)}')
    if field_type.array == 'bounded' and len(values) > wanted:
        raise ValueError(f'at most {wanted} values, not {len(values)}')
    return values


def _items(text: str) -> list[str]:
    """Split at the commas that stand outside quotes."""
    items, start, quote = [], 0, ''
    for index, char in enumerate(text):
        if quote:
            quote = '' if char == quote and text[index - 1] != '\\' else quote
        elif char in '\'"':
            quote = char
        elif char == ',':
            items.append(text[start:index].strip())
            start = index + 1
    last = text[start:].strip()
    return items + [last] if last or items else []


def _scalar(field_type: FieldType, text: str) -> Any:
    kind = KINDS[field_type.base]
    if kind.python is str:
        return _string(text, field_type.string_bound)
    if kind.python is bool:
        return _bool(text)
    if kind.python is float:
        return _float(text, kind.low, kind.high)
    number = _int(text, kind.low, kind.high)
    return bytes([number]) if kind.python is bytes else number


def _bool(text: str) -> bool:
    try:
        return {'true': True, '1': True, 'false': False, '0': False}[text.lower()]
    except KeyError:
        raise ValueError(f'true or false, not {text}') from None


def _float(text: str, low: float, high: float) -> float:
    try:
        value = float(text)
    except ValueError:
        raise ValueError(f'a number, not {text}') from None
    if low <= value <= high or value != value or value in (float('inf'), float('-inf')):
        return value
    raise ValueError(f'a number in [{low!r}, {high!r}], not {text}')


def _int(text: str, low: float, high: float) -> int:
    try:
        value = int(text, 0)
    except ValueError:
        raise ValueError(f'a whole number, not {text}') from None
    if not low <= value <= high:
        raise ValueError(f'a whole number in [{low}, {high}], not {text}')
    return value


def _string(text: str, bound: int | None) -> str:
    value = _unquoted(text)
    if bound is not None and len(value) > bound:
        raise ValueError(f'at most {bound} characters, not {len(value)}')
    return value


def _unquoted(text: str) -> str:
    quote = text[:1]
    if quote not in ('"', "'") or not quote:
        return text
    if len(text) < 2 or text[-1] != quote:
        # ROS cuts a line at the first #, also inside quotes, and would silently keep half a string.
        raise ValueError(f'a closing {quote} on the same line (ROS cuts a line at #, even inside quotes)')
    body = text[1:-1]
    if re.search(rf'(?<!\\){quote}', body):
        raise ValueError(f'one quoted string with a backslash before each inner {quote}, not {text}')
    return body.replace('\\' + quote, quote)
