"""Enumerations that ROS 2 defines in C++."""

from __future__ import annotations

from enum import Enum, EnumMeta, IntEnum
from typing import NoReturn


class CEnum(IntEnum):
    """Integers that print as `Type.MEMBER`, in every version of Python."""

    def __str__(self) -> str:
        return f'{type(self).__name__}.{self.name}'


class _Pybind11Type(EnumMeta):
    """The class of ROS 2's C++ enumerations, which have members but cannot be iterated, searched or indexed."""

    def __iter__(cls) -> NoReturn:
        raise TypeError("'pybind11_type' object is not iterable")

    def __len__(cls) -> NoReturn:
        raise TypeError("object of type 'pybind11_type' has no len()")

    def __contains__(cls, value: object) -> NoReturn:
        raise TypeError("argument of type 'pybind11_type' is not iterable")

    def __getitem__(cls, name: str) -> NoReturn:
        raise TypeError(f"type 'rclpy._rclpy_pybind11.{cls.__name__}' is not subscriptable")


class Pybind11Enum(Enum, metaclass=_Pybind11Type):
    """An enumeration whose members can be converted to an integer."""

    def __int__(self) -> int:
        return int(self.value)

    def __index__(self) -> int:
        return int(self.value)

    def __hash__(self) -> int:
        return hash(self.value)


class Pybind11IntEnum(Pybind11Enum):
    """An enumeration whose members are also equal to their integer. All members count as true, and they have no order."""

    def __eq__(self, other: object) -> bool:
        return isinstance(other, (int, Pybind11IntEnum)) and int(self) == int(other)

    def __hash__(self) -> int:
        return hash(self.value)
