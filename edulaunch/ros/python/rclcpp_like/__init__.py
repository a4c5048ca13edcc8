"""Nodes and programs that behave as in C++ where C++ and Python differ. edulaunch's versions of C++ programs use them."""

from __future__ import annotations

import sys
from collections.abc import Callable
from typing import Any

import rclpy
from rcl_interfaces.msg import ParameterDescriptor, ParameterEvent, SetParametersResult
from rclpy.clock import Clock
from rclpy.clock_type import ClockType
from rclpy.exceptions import (
    InvalidNamespaceException,
    InvalidNodeNameException,
    InvalidServiceNameException,
    InvalidTopicNameException,
)
from rclpy.executors import ExternalShutdownException
from rclpy.logging import get_logger
from rclpy.node import Node
from rclpy.parameter import Parameter
from rclpy.publisher import Publisher
from rclpy.qos import QoSProfile, ReliabilityPolicy
from rclpy.subscription import Subscription
from rclpy.timer import Timer

from edulaunch.engine.processes.current import current_process
from edulaunch.engine.processes.spec import Signals
from edulaunch.ros.node_facts import core_of

_NAMES: tuple[tuple[type[Exception], str], ...] = (
    (InvalidTopicNameException, 'rclcpp::exceptions::InvalidTopicNameError'),
    (InvalidServiceNameException, 'rclcpp::exceptions::InvalidServiceNameError'),
    (InvalidNodeNameException, 'rclcpp::exceptions::InvalidNodeNameError'),
    (InvalidNamespaceException, 'rclcpp::exceptions::InvalidNamespaceError'),
)


class CppError(Exception):
    """An exception that a C++ program does not catch.

    :param cpp_name: the name of the exception's class in C++, as the C++ runtime prints it.
    """

    cpp_name = 'std::runtime_error'


class InvalidParameterType(CppError):
    """At start-up, a parameter received a value of another type than the declared type."""

    cpp_name = 'rclcpp::exceptions::InvalidParameterTypeException'


class InvalidParameterValue(CppError):
    """At start-up, a parameter received a value outside its range."""

    cpp_name = 'rclcpp::exceptions::InvalidParameterValueException'


def cpp_name_of(error: Exception) -> str | None:
    """Return the name of the C++ class that corresponds to `error`, or None if C++ has no such class."""
    if isinstance(error, CppError):
        return error.cpp_name
    for kind, name in _NAMES:
        if isinstance(error, kind):
            return name
    return None


def _type_name(kind: Parameter.Type) -> str:
    return 'not set' if kind is Parameter.Type.NOT_SET else kind.name.lower()


def type_refusal(name: str, declared: Parameter.Type, given: Parameter.Type) -> str:
    """Return the reason for rejecting a value of another type."""
    return (
        f'Wrong parameter type, parameter {{{name}}} is of type {{{_type_name(declared)}}}, '
        f'setting it to {{{_type_name(given)}}} is not allowed.'
    )


def range_refusal(name: str, value: Any, descriptor: Any) -> str | None:
    """Return the reason for rejecting a number outside the descriptor's range or between its steps. Return None for an allowed
    number.
    """
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


_EVENT_QOS = (('depth', 1000), ('durability', 'volatile'), ('history', 'keep_last'), ('reliability', 'reliable'))


class CppNode(Node):
    """A node that other nodes see as a C++ node.

    It subscribes to /parameter_events, has the read-only qos_overrides parameters of that topic, and rejects parameter values
    with rclcpp's messages. An invalid value at start-up raises an error that ends the program.
    """

    def __init__(self, node_name: str, **options: Any) -> None:
        self._tolerant = bool(options.get('allow_undeclared_parameters'))
        super().__init__(node_name, **options)
        for policy, value in _EVENT_QOS:
            name = f'qos_overrides./parameter_events.publisher.{policy}'
            if not self.has_parameter(name):
                self.declare_parameter(name, value, ParameterDescriptor(read_only=True))
        self._steady_clock = Clock(clock_type=ClockType.STEADY_TIME)
        qos = QoSProfile(depth=100, reliability=ReliabilityPolicy.BEST_EFFORT)
        self._parameter_events = self.create_subscription(ParameterEvent, '/parameter_events', self.on_parameter_event, qos)

    def create_publisher(self, msg_type: Any, topic: str, qos_profile: QoSProfile | int, **options: Any) -> Publisher:
        """Create a publisher as rclpy does. rclcpp's warnings about the publisher contain the full name of the topic."""
        return super().create_publisher(msg_type, core_of(self).resolve(topic, 'topic', only_expand=True), qos_profile, **options)

    def create_subscription(
        self, msg_type: Any, topic: str, callback: Callable[..., Any], qos_profile: QoSProfile | int, **options: Any
    ) -> Subscription:
        """Create a subscription as rclpy does. rclcpp's warnings about the subscription contain the full name of the topic."""
        name = core_of(self).resolve(topic, 'topic', only_expand=True)
        return super().create_subscription(msg_type, name, callback, qos_profile, **options)

    def create_wall_timer(self, period_s: float, callback: Callable[[], object]) -> Timer:
        """Return a timer on the steady clock of the machine, so that it also fires while no node publishes /clock."""
        return self.create_timer(period_s, callback, clock=self._steady_clock)

    def on_parameter_event(self, event: ParameterEvent) -> None:
        """Handle a parameter event of any node. The base class does nothing."""

    def declare_parameter(self, name: str, value: Any = None, descriptor: Any = None, ignore_override: bool = False) -> Parameter:
        """Declare a parameter as rclpy does, but raise rclcpp's errors.

        :raises InvalidParameterType: when the value at start-up has another type.
        :raises InvalidParameterValue: when the value is out of range.
        """
        override = None if ignore_override else core_of(self).overrides.get(name)
        descriptor = descriptor or ParameterDescriptor()
        if override is not None and value is not None and not descriptor.dynamic_typing:
            declared = Parameter.Type.from_parameter_value(value)
            kind = Parameter.Type.from_parameter_value(override.value)
            if kind != declared:
                raise InvalidParameterType(f"parameter '{name}' has invalid type: {type_refusal(name, declared, kind)}")
            refusal = range_refusal(name, override.value, descriptor)
            if refusal:
                raise InvalidParameterValue(f"parameter '{name}' could not be set: {refusal}")
        return super().declare_parameter(name, value, descriptor, ignore_override)

    def set_parameters(self, parameter_list: list[Parameter]) -> list[SetParametersResult]:
        """Set each parameter separately. A rejected value is reported in the result, not as an exception."""
        return [self.set_parameters_atomically([parameter]) for parameter in parameter_list]

    def set_parameters_atomically(self, parameter_list: list[Parameter]) -> SetParametersResult:
        """Set all parameters, or no parameter if one is rejected."""
        for parameter in parameter_list:
            refusal = self._refusal(parameter)
            if refusal is not None:
                return SetParametersResult(successful=False, reason=refusal)
        return super().set_parameters_atomically(parameter_list)

    def _refusal(self, parameter: Parameter) -> str | None:
        name = parameter.name
        if not self.has_parameter(name):
            return None if self._tolerant else f"parameter '{name}' cannot be set because it was not declared"
        descriptor = self.describe_parameter(name)
        if descriptor.read_only:
            return f"parameter '{name}' cannot be set because it is read-only"
        declared = self.get_parameter(name).type_
        if parameter.type_ is Parameter.Type.NOT_SET:
            is_static = declared is not Parameter.Type.NOT_SET and not descriptor.dynamic_typing
            return 'cannot undeclare a statically typed parameter' if is_static else None
        free = descriptor.dynamic_typing or declared is Parameter.Type.NOT_SET
        if not free and parameter.type_ != declared:
            return type_refusal(name, declared, parameter.type_)
        return range_refusal(name, parameter.value, descriptor)


def run_program(main: Callable[[], int | None]) -> int:
    """Run `main` between rclpy's init and shutdown, and return the exit code of the C++ program.

    Ctrl-C is logged and ends the program normally. An exception that also exists in C++ is printed as the C++ runtime prints it,
    and aborts the program (signal 6).
    """
    try:
        rclpy.init(args=[_without_half_characters(argument) for argument in current_process().argv])
        return _run(main)
    except KeyboardInterrupt:
        get_logger('rclcpp').info('signal_handler(signum=2)')
    finally:
        rclpy.try_shutdown()
    return 0


def _without_half_characters(argument: str) -> str:
    """Return the argument as valid UTF-8. C++ accepts any byte, but rclpy would raise a UnicodeEncodeError."""
    return argument.encode('utf-8', 'surrogatepass').decode('utf-8', 'replace')


def _run(main: Callable[[], int | None]) -> int:
    try:
        return main() or 0
    except ExternalShutdownException:
        return 0
    except Exception as error:
        name = cpp_name_of(error)
        if name is None:
            if rclpy.ok():
                raise
            raise KeyboardInterrupt from None  # the real rclpy raises this when it waits or publishes; rclcpp ends normally
        process = current_process()
        text = f"terminate called after throwing an instance of '{name}'\n  what():  {error}\n"
        process.write('stderr', text)
        process.lifecycle.exit_now(-Signals.SIGABRT)


def program(main: Callable[[], int | None]) -> Callable[[], None]:
    """Return the entry point of a C++ program. It calls `main` through :func:`run_program` and exits with the returned code."""
    return lambda: sys.exit(run_program(main))


def spinning(make_node: Callable[..., Node], *args: Any, **options: Any) -> Callable[[], None]:
    """Return the entry point of a C++ program that creates a node with `make_node` and spins it."""
    return program(lambda: rclpy.spin(make_node(*args, **options)))
