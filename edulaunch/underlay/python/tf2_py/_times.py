"""Times and durations as tf2 takes them: anything with `nanoseconds`, or with `sec` and `nanosec`."""

from __future__ import annotations

from typing import Any


def nanoseconds(value: Any, name: str = 'time') -> int:
    """Integer nanoseconds of an rclpy or builtin_interfaces time or duration.

    :raises TypeError: for anything else, numbers included.
    """
    try:
        return value.nanoseconds  # type: ignore[no-any-return]
    except AttributeError:
        pass
    try:
        return value.sec * 1_000_000_000 + value.nanosec  # type: ignore[no-any-return]
    except AttributeError:
        raise TypeError(f'{name} must have sec and nanosec, or nanoseconds.') from None
