"""Enumerations that ROS 2 defines in C++."""

from __future__ import annotations

from enum import IntEnum


class CEnum(IntEnum):
    """Integers that print as `Type.MEMBER`, also in Python 3.11 and later."""

    def __str__(self) -> str:
        return f'{type(self).__name__}.{self.name}'
