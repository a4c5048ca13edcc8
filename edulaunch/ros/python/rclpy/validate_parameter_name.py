"""The rules for parameter names."""

from __future__ import annotations

from rclpy.exceptions import InvalidParameterException


def validate_parameter_name(name: str) -> bool:
    """Return True. Raise InvalidParameterException for the empty name."""
    if not name:
        raise InvalidParameterException(name)
    return True
