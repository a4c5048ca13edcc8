"""Parameter values: their types, their conversion from strings, their ranges, and the node patterns of parameter files."""

from __future__ import annotations

from collections.abc import Sequence
from math import isclose
from typing import Any

TYPE_NAMES = (
    'NOT_SET',
    'BOOL',
    'INTEGER',
    'DOUBLE',
    'STRING',
    'BYTE_ARRAY',
    'BOOL_ARRAY',
    'INTEGER_ARRAY',
    'DOUBLE_ARRAY',
    'STRING_ARRAY',
)
"""The parameter types; the index is the number used in rcl_interfaces/ParameterType."""

NOT_SET, BOOL, INTEGER, DOUBLE, STRING, BYTE_ARRAY, BOOL_ARRAY, INTEGER_ARRAY, DOUBLE_ARRAY, STRING_ARRAY = range(10)

_SCALAR_TYPES: dict[type, int] = {bool: BOOL, int: INTEGER, float: DOUBLE, str: STRING}
_ARRAY_TYPES = ((bytes, BYTE_ARRAY), (bool, BOOL_ARRAY), (int, INTEGER_ARRAY), (float, DOUBLE_ARRAY), (str, STRING_ARRAY))
_TRUE = frozenset(('Y', 'y', 'yes', 'Yes', 'YES', 'true', 'True', 'TRUE', 'on', 'On', 'ON'))
_FALSE = frozenset(('N', 'n', 'no', 'No', 'NO', 'false', 'False', 'FALSE', 'off', 'Off', 'OFF'))
_DOTTED_FLOATS = {
    f'{sign}.{word}': f'{sign}{word}' for sign in ('', '+', '-') for word in ('nan', 'NaN', 'NAN', 'inf', 'Inf', 'INF')
}
_TOLERANCE = 1e-6
_INT64 = range(-(1 << 63), 1 << 63)


def type_of_value(value: Any) -> int:
    """Return the number of the parameter type of `value`.

    An empty sequence is a byte array, as in rclpy.

    :raises TypeError: if no parameter type fits `value`.
    """
    if value is None:
        return NOT_SET
    for python_type, number in _SCALAR_TYPES.items():
        if isinstance(value, python_type):
            return number
    if isinstance(value, (list, tuple)) or type(value).__name__ == 'array':
        for python_type, number in _ARRAY_TYPES:
            if all(isinstance(item, python_type) for item in value):
                return number
        raise TypeError(f"The given value is not a list of one of the allowed types '{value}'.")
    raise TypeError(f"The given value is not one of the allowed types '{value}'.")


def precedence(value: Any) -> int:
    """Return the rank of a value among several values of one parameter. A lower rank takes precedence.

    The rank is the number of the parameter type. A value without a type has the highest rank.
    """
    try:
        return type_of_value(value) or STRING_ARRAY + 1
    except TypeError:
        return STRING_ARRAY + 1


def value_fits(value: Any, number: int) -> bool:
    """Return whether a parameter of type `number` can have this value."""
    if number == NOT_SET:
        return value is None
    if number < BYTE_ARRAY:
        return isinstance(value, (bool, int, float, str)[number - 1])
    if not (isinstance(value, (list, tuple)) or type(value).__name__ == 'array'):
        return False
    if number == BYTE_ARRAY:
        return all(isinstance(item, bytes) and len(item) == 1 for item in value)
    python_type = (bool, int, float, str)[number - BOOL_ARRAY]
    return all(isinstance(item, python_type) for item in value)


def scalar_from_text(text: str) -> Any:
    """Return the value of an unquoted scalar, according to rcl's parameter parser (YAML 1.1 booleans, C numbers).

    `off` is False, `0x10` is 16, `010` is 8, `1e3` is 1000.0. A scalar that is neither a boolean nor a number is a
    string.
    """
    if text in _TRUE:
        return True
    if text in _FALSE:
        return False
    integer = _c_integer(text)
    return integer if integer is not None else _c_float(text)


def _c_integer(text: str) -> int | None:
    digits = text.lstrip(' \t\n\r\v\f')
    sign, digits = (digits[0], digits[1:]) if digits[:1] in ('+', '-') else ('', digits)
    if digits[:2] in ('0x', '0X'):
        digits, base, allowed = digits[2:], 16, '0123456789abcdefABCDEF'
    else:
        base, allowed = (8, '01234567') if digits[:1] == '0' else (10, '0123456789')
    if not digits or digits.strip(allowed):
        return None
    value = int(sign + digits, base)
    return value if value in _INT64 else None


def _c_float(text: str) -> float | str:
    text_for_c = _DOTTED_FLOATS.get(text, text)
    if text_for_c[-1:].isspace() or '_' in text_for_c or not text_for_c.isascii():
        return text
    try:
        return float(text_for_c)
    except ValueError:
        pass
    hexadecimal = text_for_c.lstrip('+-')[:2] in ('0x', '0X')
    try:
        return float.fromhex(text_for_c) if hexadecimal else text
    except (ValueError, OverflowError):
        return text


def sequence_type_name(value: Any) -> str:
    """Return the name of a scalar's type in rcl's error messages about lists."""
    return {BOOL: 'bool', INTEGER: 'integer', DOUBLE: 'double', STRING: 'string'}[type_of_value(value)]


def integer_range_problem(name: str, value: int, lowest: int, highest: int, step: int) -> str | None:
    """Return why rclpy rejects an integer because of its range or step, in the words of rclpy. Return None if the value is
    allowed.

    Both limits are always allowed. `lowest` may be greater than `highest`.
    """
    lowest, highest = min(lowest, highest), max(lowest, highest)
    if value in (lowest, highest):
        return None
    if not lowest <= value <= highest:
        return f'Parameter {name} out of range. Min: {lowest}, Max: {highest}, value: {value}'
    if step and (value - lowest) % step:
        return f'The parameter value for {name} is not a valid step. Min: {lowest}, max: {highest}, value: {value}, step: {step}'
    return None


def float_range_problem(name: str, value: float, lowest: float, highest: float, step: float) -> str | None:
    """Return why rclpy rejects a float because of its range or step, in the words of rclpy. Return None if the value is
    allowed.

    Limits and steps have a relative tolerance of 1e-6. `lowest` may be greater than `highest`.
    """
    lowest, highest = min(lowest, highest), max(lowest, highest)
    if _close(value, lowest) or _close(value, highest):
        return None
    if not lowest < value < highest:
        return f'Parameter {name} out of range Min: {lowest}, Max: {highest}, value: {value}'
    if step:
        nearest = lowest + round((value - lowest) / step) * step
        if not _close(value, nearest):
            return (
                f'The parameter value for {name} is not close enough to a valid step. '
                f'Min: {lowest}, max: {highest}, value: {value}, step: {step}'
            )
    return None


def _close(first: float, second: float) -> bool:
    return isclose(first, second, rel_tol=_TOLERANCE)


def pattern_matches(pattern: str, fully_qualified_name: str) -> bool:
    """Return whether a node pattern of a parameter file (`/sim`, `/*/sim`, `/**`) matches a fully qualified node name.

    `*` matches exactly one token, and `**` matches any number of tokens.
    """
    return _tokens_match(pattern.strip('/').split('/'), fully_qualified_name.strip('/').split('/'))


def _tokens_match(pattern: Sequence[str], tokens: Sequence[str]) -> bool:
    if not pattern:
        return not tokens
    if pattern[0] == '**':
        return any(_tokens_match(pattern[1:], tokens[start:]) for start in range(len(tokens) + 1))
    return bool(tokens) and pattern[0] in ('*', tokens[0]) and _tokens_match(pattern[1:], tokens[1:])
