"""Errors as a C++ program reports them: the exception's C++ name and its text."""

from __future__ import annotations

from rclpy.exceptions import (
    InvalidNamespaceException,
    InvalidNodeNameException,
    InvalidServiceNameException,
    InvalidTopicNameException,
)

_NAMES: tuple[tuple[type[Exception], str], ...] = (
    (InvalidTopicNameException, 'rclcpp::exceptions::InvalidTopicNameError'),
    (InvalidServiceNameException, 'rclcpp::exceptions::InvalidServiceNameError'),
    (InvalidNodeNameException, 'rclcpp::exceptions::InvalidNodeNameError'),
    (InvalidNamespaceException, 'rclcpp::exceptions::InvalidNamespaceError'),
)


class CppError(Exception):
    """An exception that a C++ program does not catch.

    :param cpp_name: its class in C++, as the runtime prints it.
    """

    cpp_name = 'std::runtime_error'


class InvalidParameterType(CppError):
    """A parameter was given, at start-up, a value of another type than the program declares."""

    cpp_name = 'rclcpp::exceptions::InvalidParameterTypeException'


class InvalidParameterValue(CppError):
    """A parameter was given, at start-up, a value outside its range."""

    cpp_name = 'rclcpp::exceptions::InvalidParameterValueException'


def cpp_name_of(error: Exception) -> str | None:
    """The C++ class that stands for `error`; None when the error has no counterpart there."""
    if isinstance(error, CppError):
        return error.cpp_name
    for kind, name in _NAMES:
        if isinstance(error, kind):
            return name
    return None
