"""Messages of `test_msgs` with useful test values: `get_test_msg('BasicTypes')` covers the limits of each type's range."""

from __future__ import annotations

import re
from functools import partial
from typing import Any

from test_msgs import msg

_BITS = {'int8': 8, 'int16': 16, 'int32': 32, 'int64': 64}
_TEXTS = ('', 'Hello world!', 'Hellö wörld!', 'ハローワールド')
_REALS = {'float': (0.0, 1.125, 2.0**100, -(2.0**100)), 'double': (0.0, 1.125, 1.7e308, -1.7e308)}
_COUNTS = {'UnboundedSequences': (0, 1, 3, 8, 100), 'BoundedSequences': (0, 3), 'BoundedPlainSequences': (0, 3)}
_ALIKE = ('Empty', 'Constants', 'Defaults')
"""Messages whose fields keep their defaults."""
_OF_EACH_CORNER = ('BasicTypes', 'Strings', 'WStrings', 'Nested')
_NAMES = (*_ALIKE, *_OF_EACH_CORNER, *_COUNTS, 'Arrays', 'Builtins', 'MultiNested')


def get_test_msg(message_name: str) -> list[Any]:
    """Return some messages of a type of `test_msgs`: empty messages, and messages with small, largest and smallest values.

    :raises NotImplementedError: for an unknown type.
    """
    if message_name not in _NAMES:
        raise NotImplementedError
    cls = getattr(msg, message_name)
    if message_name in _ALIKE:
        return [cls()]
    if message_name in _OF_EACH_CORNER:
        return [_filled(cls, corner, 3) for corner in range(4)]
    return [_filled(cls, 1, count) for count in _COUNTS.get(message_name, (3,))]


def _filled(cls: Any, corner: int, count: int) -> Any:
    """Return a message with a value in each field. Unbounded lists get `count` entries.

    :param corner: the kind of value: 0 for empty, 1 for small, 2 for the largest, 3 for the smallest.
    """
    message = cls()
    for name, type_text in cls.get_fields_and_field_types().items():
        if not name.startswith(('string_value_default', 'wstring_value_default')):
            setattr(message, name, _value(type_text, corner, count))
    return message


def _value(type_text: str, corner: int, count: int) -> Any:
    if type_text.startswith('sequence<'):
        item, _, bound = type_text[len('sequence<') : -1].partition(', ')
        return [_value(item, 1 + n % 3, 3) for n in range(min(count, int(bound or count)))]
    if type_text.endswith(']'):
        item, _, length = type_text[:-1].rpartition('[')
        return [_value(item, 1 + n % 3, 3) for n in range(int(length))]
    if '/' in type_text:
        from rosidl_runtime_py.utilities import get_message

        package, name = type_text.split('/')
        return _filled(get_message(f'{package}/msg/{name}'), corner, count)
    return _scalar(type_text, corner)


def _scalar(type_text: str, corner: int) -> Any:
    if type_text == 'boolean':
        return corner in (1, 2)
    if type_text == 'octet':
        return bytes([(0, 1, 255, 0)[corner]])
    if type_text in _REALS:
        return _REALS[type_text][corner]
    if 'string' in type_text:
        return _TEXTS[corner]
    signed = type_text.removeprefix('u')
    bits = _BITS[signed]
    least, most = (-(2 ** (bits - 1)), 2 ** (bits - 1) - 1) if signed == type_text else (0, 2**bits - 1)
    return (0, 1, most, least)[corner]


for _name in _NAMES:  # defines get_msg_basic_types() and similar functions
    globals()['get_msg_' + re.sub('(?<=[a-z])([A-Z])', r'_\1', _name).lower()] = partial(get_test_msg, _name)
