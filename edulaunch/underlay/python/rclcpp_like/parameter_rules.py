"""Why a C++ node refuses a parameter value, in rclcpp's words."""

from __future__ import annotations

from typing import Any

from rclpy.parameter import Parameter

_TYPE_NAMES = {
    Parameter.Type.NOT_SET: 'not set',
    Parameter.Type.BOOL: 'bool',
    Parameter.Type.INTEGER: 'integer',
    Parameter.Type.DOUBLE: 'double',
    Parameter.Type.STRING: 'string',
    Parameter.Type.BYTE_ARRAY: 'byte_array',
    Parameter.Type.BOOL_ARRAY: 'bool_array',
    Parameter.Type.INTEGER_ARRAY: 'integer_array',
    Parameter.Type.DOUBLE_ARRAY: 'double_array',
    Parameter.Type.STRING_ARRAY: 'string_array',
}


def type_refusal(name: str, declared: Parameter.Type, given: Parameter.Type) -> str:
    """The reason for refusing a value of another type."""
    return (
        f'Wrong parameter type, parameter {{{name}}} is of type {{{_TYPE_NAMES[declared]}}}, '
        f'setting it to {{{_TYPE_NAMES[given]}}} is not allowed.'
    )


def range_refusal(name: str, value: Any, descriptor: Any) -> str | None:
    """The reason for refusing a number outside the descriptor's range or off its steps, or None."""
    for limits in descriptor.integer_range:
        if not _complies(value, limits.from_value, limits.to_value, limits.step, 0):
            return f"Parameter {{{name}}} doesn't comply with integer range."
    for limits in descriptor.floating_point_range:
        if not _complies(value, limits.from_value, limits.to_value, limits.step, 1e-9):
            return f"Parameter {{{name}}} doesn't comply with floating point range."
    return None


def _complies(value: float, low: float, high: float, step: float, tolerance: float) -> bool:
    if value in (low, high):
        return True
    if not low <= value <= high:
        return False
    return not step or abs((value - low) - round((value - low) / step) * step) <= tolerance
