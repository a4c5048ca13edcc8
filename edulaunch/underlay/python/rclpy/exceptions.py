"""Exceptions that rclpy raises, with ROS 2 Jazzy's texts."""
from __future__ import annotations

from typing import Any

from edulaunch.graph.names import caret_text
from rclpy._rclpy_pybind11 import InvalidHandle
from rclpy.impl.hints import hinted

__all__ = [
    'InvalidHandle', 'InvalidNamespaceException', 'InvalidNodeNameException', 'InvalidParameterException',
    'InvalidParameterTypeException', 'InvalidParameterValueException', 'InvalidServiceNameException',
    'InvalidTopicNameException', 'InvalidTypeSupport', 'NameValidationException', 'NoImplementationAvailableException',
    'NoParameterOverrideProvidedException', 'NoTypeSupportImportedException', 'NotInitializedException',
    'ParameterAlreadyDeclaredException', 'ParameterException', 'ParameterImmutableException',
    'ParameterNotDeclaredException', 'ParameterUninitializedException', 'ROSInterruptException',
]


class NotInitializedException(Exception):
    """ROS 2 is used before `rclpy.init()`."""

    def __init__(self, *args: object) -> None:
        super().__init__('rclpy.init() has not been called' + ''.join(f'. msg:{arg}' for arg in args))


class NoImplementationAvailableException(Exception):
    """No middleware could be loaded."""

    def __init__(self, *args: object) -> None:
        super().__init__('no rmw implementation with a Python extension available', *args)


class NoTypeSupportImportedException(Exception):
    """An interface class without type support is used."""

    def __init__(self, *args: object) -> None:
        super().__init__('no type_support imported', *args)


class InvalidTypeSupport(Exception):
    """Something that is no interface class is used as one."""

    def __init__(self, *args: object) -> None:
        super().__init__('invalid type support', *args)


class NameValidationException(ValueError):
    """A name breaks ROS 2's rules. The text shows the reason, the name, and a caret under the offending character.

    :ivar name_type: 'node name', 'namespace', 'topic name' or 'service name'.
    :ivar name: the refused name.
    :ivar error_msg: the reason.
    :ivar invalid_index: where in the name it goes wrong.
    """

    def __init__(self, name_type: str, name: str, error_msg: str, invalid_index: int, *args: object) -> None:
        self.name_type = name_type
        self.name = name
        self.error_msg = error_msg
        self.invalid_index = invalid_index
        super().__init__(caret_text(name_type, name, (error_msg, invalid_index)), *args)


class InvalidNamespaceException(NameValidationException):
    """A namespace breaks the rules."""

    def __init__(self, name: str, error_msg: str, invalid_index: int, *args: object) -> None:
        super().__init__('namespace', name, error_msg, invalid_index)


class InvalidNodeNameException(NameValidationException):
    """A node name breaks the rules."""

    def __init__(self, name: str, error_msg: str, invalid_index: int, *args: object) -> None:
        super().__init__('node name', name, error_msg, invalid_index)


class InvalidTopicNameException(NameValidationException):
    """A topic name breaks the rules."""

    def __init__(self, name: str, error_msg: str, invalid_index: int, *args: object) -> None:
        super().__init__('topic name', name, error_msg, invalid_index)


class InvalidServiceNameException(NameValidationException):
    """A service name breaks the rules."""

    def __init__(self, name: str, error_msg: str, invalid_index: int, *args: object) -> None:
        super().__init__('service name', name, error_msg, invalid_index)


class ParameterException(Exception):
    """Base of what goes wrong with parameters; the text ends with the names concerned."""

    def __init__(self, error_msg: str, parameters: Any, *args: object) -> None:
        super().__init__(f'{error_msg}: {parameters}', *args)


class ParameterNotDeclaredException(ParameterException):
    """A parameter is used that was never declared."""

    def __init__(self, parameters: Any, *args: object) -> None:
        super().__init__('Invalid access to undeclared parameter(s)', parameters, *args)


class ParameterAlreadyDeclaredException(ParameterException):
    """A parameter is declared twice."""

    def __init__(self, parameters: Any, *args: object) -> None:
        super().__init__('Parameter(s) already declared', parameters, *args)


class InvalidParameterException(ParameterException):
    """A parameter name is empty."""

    def __init__(self, parameter: Any, *args: object) -> None:
        super().__init__('Invalid parameter name', parameter, *args)


def _type_hint(given: Any, expected: str) -> str | None:
    """What to try for the commonest mistakes with types."""
    kind, value = given.type_.name, given.value
    if (kind, expected) == ('INTEGER', 'DOUBLE'):
        return f'a double is written with its point: {float(value)}'
    if (kind, expected) == ('DOUBLE', 'INTEGER'):
        return f'an integer is written without a point: {int(value)}'
    if expected == 'STRING' and kind in ('INTEGER', 'DOUBLE', 'BOOL'):
        return 'put it in quotation marks, or YAML takes it for something else than a text'
    return None


class InvalidParameterTypeException(ParameterException):
    """A value has another type than the parameter was declared with."""

    def __init__(self, desired_parameter: Any, expected_type: str) -> None:
        super().__init__(
            f"Trying to set parameter '{desired_parameter.name}' to '{desired_parameter.value}' "
            f"of type '{desired_parameter.type_.name}', expecting type '{expected_type}'",
            desired_parameter.name)
        hinted(self, _type_hint(desired_parameter, expected_type))
        self.param_name = desired_parameter.name
        self.param_type = desired_parameter.type_.name
        self.expected_type = expected_type


class InvalidParameterValueException(ParameterException):
    """A value is refused by the parameter's range or by a callback."""

    def __init__(self, parameter: Any, value: Any, reason: str) -> None:
        super().__init__(f'Invalid parameter value ({value}) for parameter. Reason: {reason}', parameter)


class ParameterImmutableException(ParameterException):
    """A read-only parameter is changed."""

    def __init__(self, parameter: Any, *args: object) -> None:
        super().__init__('Attempted to modify read-only parameter', parameter, *args)


class ParameterUninitializedException(ParameterException):
    """A parameter that was declared with a type only is read before it has a value."""

    def __init__(self, parameter: str, *args: object) -> None:
        Exception.__init__(self, f"The parameter '{parameter}' is not initialized", *args)


class NoParameterOverrideProvidedException(ParameterUninitializedException):
    """A parameter that needs a value from outside got none."""


class ROSInterruptException(Exception):
    """ROS 2 was shut down while something waited."""

    def __init__(self, *args: object) -> None:
        super().__init__('rclpy.shutdown() has been called', *args)
