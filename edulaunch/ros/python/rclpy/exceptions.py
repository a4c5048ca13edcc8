"""The exceptions that rclpy raises, with the messages of ROS 2 Jazzy."""

from __future__ import annotations

from typing import Any

from edulaunch.engine.facts import with_facts
from edulaunch.engine.graph.names import caret_text
from rclpy._rclpy_pybind11 import InvalidHandle as InvalidHandle


class NotInitializedException(Exception):
    """A program uses ROS 2 before `rclpy.init()`."""

    def __init__(self, message: str | None = None) -> None:
        super().__init__('rclpy.init() has not been called.' + (f' msg:{message}' if message else ''))


class NoTypeSupportImportedException(Exception):
    """A program uses an interface class without type support."""

    def __init__(self) -> None:
        super().__init__('no type_support imported')


class NameValidationException(Exception):
    """A name breaks ROS 2's rules. The message contains the reason, the name, and a caret under the invalid character."""

    def __init__(self, name_type: str, name: str, error_msg: str, invalid_index: int) -> None:
        super().__init__(caret_text(name_type, name, (error_msg, invalid_index)))


class InvalidNamespaceException(NameValidationException):
    """A namespace breaks ROS 2's rules for namespaces."""

    def __init__(self, name: str, error_msg: str, invalid_index: int) -> None:
        super().__init__('namespace', name, error_msg, invalid_index)


class InvalidNodeNameException(NameValidationException):
    """A node name breaks ROS 2's rules for node names."""

    def __init__(self, name: str, error_msg: str, invalid_index: int) -> None:
        super().__init__('node name', name, error_msg, invalid_index)


class InvalidTopicNameException(NameValidationException):
    """A topic name breaks ROS 2's rules for topic names."""

    def __init__(self, name: str, error_msg: str, invalid_index: int) -> None:
        super().__init__('topic name', name, error_msg, invalid_index)


class InvalidServiceNameException(NameValidationException):
    """A service name breaks ROS 2's rules for service names."""

    def __init__(self, name: str, error_msg: str, invalid_index: int) -> None:
        super().__init__('service name', name, error_msg, invalid_index)


class ParameterException(Exception):
    """The base class of errors about parameters. The message ends with the names of the parameters."""

    def __init__(self, error_msg: str, parameters: Any) -> None:
        super().__init__(f'{error_msg}: {parameters}')


class ParameterNotDeclaredException(ParameterException):
    """A program uses a parameter that was never declared."""

    def __init__(self, parameters: Any) -> None:
        super().__init__('Invalid access to undeclared parameter(s)', parameters)


class ParameterAlreadyDeclaredException(ParameterException):
    """A program declares a parameter twice."""

    def __init__(self, parameters: Any) -> None:
        super().__init__('Parameter(s) already declared', parameters)


class InvalidParameterException(ParameterException):
    """A parameter name is empty."""

    def __init__(self, parameter_name: Any) -> None:
        super().__init__('Invalid parameter name', parameter_name)


class InvalidParameterTypeException(ParameterException):
    """A value does not have the declared type of its parameter."""

    def __init__(self, desired_parameter: Any, expected_type: str) -> None:
        super().__init__(
            f"Trying to set parameter '{desired_parameter.name}' to '{desired_parameter.value}' "
            f"of type '{desired_parameter.type_.name}', expecting type '{expected_type}'",
            desired_parameter.name,
        )
        with_facts(
            self,
            'programs.parameter-type',
            parameter=desired_parameter.name,
            value=str(desired_parameter.value),
            given=desired_parameter.type_.name,
            expected=expected_type,
        )


class InvalidParameterValueException(ParameterException):
    """A parameter cannot have a value, because its range or a callback rejects the value."""

    def __init__(self, parameter: Any, value: Any, reason: str) -> None:
        super().__init__(f'Invalid parameter value ({value}) for parameter. Reason: {reason}', parameter)


class ParameterImmutableException(ParameterException):
    """A program changes a read-only parameter."""

    def __init__(self, parameter_name: Any) -> None:
        super().__init__('Attempted to modify read-only parameter', parameter_name)


class ParameterUninitializedException(ParameterException):
    """A program reads a parameter that was declared with a type only and has no value yet."""

    def __init__(self, parameter_name: str) -> None:
        super().__init__(f"The parameter '{parameter_name}' is not initialized", parameter_name)


class ROSInterruptException(Exception):
    """ROS 2 was shut down while a program waited."""

    def __init__(self) -> None:
        super().__init__('rclpy.shutdown() has been called')
