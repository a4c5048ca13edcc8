"""A node as rclcpp makes it."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from rcl_interfaces.msg import ParameterDescriptor, ParameterEvent, SetParametersResult
from rclpy.clock import Clock
from rclpy.clock_type import ClockType
from rclpy.node import Node
from rclpy.parameter import Parameter
from rclpy.publisher import Publisher
from rclpy.qos import QoSProfile, ReliabilityPolicy
from rclpy.subscription import Subscription
from rclpy.timer import Timer

from rclcpp_like.errors import InvalidParameterType, InvalidParameterValue

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


_EVENT_QOS = (('depth', 1000), ('durability', 'volatile'), ('history', 'keep_last'), ('reliability', 'reliable'))


class CppNode(Node):
    """A node that others take for a C++ node.

    It listens to /parameter_events, has the read-only qos_overrides parameters of that topic, and refuses
    parameter values in rclcpp's words. A bad value given at start-up is an error that ends the program.
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
        """As rclpy's; rclcpp's warnings about it name the topic in full."""
        return super().create_publisher(msg_type, self._rclpy.resolve(topic, 'topic', only_expand=True), qos_profile, **options)

    def create_subscription(
        self, msg_type: Any, topic: str, callback: Callable[..., Any], qos_profile: QoSProfile | int, **options: Any
    ) -> Subscription:
        """As rclpy's; rclcpp's warnings about it name the topic in full."""
        name = self._rclpy.resolve(topic, 'topic', only_expand=True)
        return super().create_subscription(msg_type, name, callback, qos_profile, **options)

    def create_wall_timer(self, period_s: float, callback: Callable[[], object]) -> Timer:
        """A timer that goes by the machine's steady clock, so that it also fires while nobody publishes /clock."""
        return self.create_timer(period_s, callback, clock=self._steady_clock)

    def on_parameter_event(self, event: ParameterEvent) -> None:
        """Called for every parameter event of every node; the plain node has no use for it."""

    def declare_parameter(self, name: str, value: Any = None, descriptor: Any = None, ignore_override: bool = False) -> Parameter:
        """As rclpy's, with rclcpp's errors.

        :raises InvalidParameterType: the value given at start-up is of another type.
        :raises InvalidParameterValue: it is out of range.
        """
        override = None if ignore_override else self._rclpy.overrides.get(name)
        descriptor = descriptor or ParameterDescriptor()
        if override is not None and value is not None and not descriptor.dynamic_typing:
            declared = Parameter.Type.from_parameter_value(value)
            given = Parameter.Type.from_parameter_value(override.value)
            if given != declared:
                raise InvalidParameterType(f"parameter '{name}' has invalid type: {type_refusal(name, declared, given)}")
            refusal = range_refusal(name, override.value, descriptor)
            if refusal:
                raise InvalidParameterValue(f"parameter '{name}' could not be set: {refusal}")
        return super().declare_parameter(name, value, descriptor, ignore_override)

    def set_parameters(self, parameter_list: list[Parameter]) -> list[SetParametersResult]:
        """Set each parameter by itself; refusals are results, not exceptions."""
        return [self.set_parameters_atomically([parameter]) for parameter in parameter_list]

    def set_parameters_atomically(self, parameter_list: list[Parameter]) -> SetParametersResult:
        """Set all of them or none."""
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
            kept = declared is not Parameter.Type.NOT_SET and not descriptor.dynamic_typing
            return 'cannot undeclare a statically typed parameter' if kept else None
        free = descriptor.dynamic_typing or declared is Parameter.Type.NOT_SET
        if not free and parameter.type_ != declared:
            return type_refusal(name, declared, parameter.type_)
        return range_refusal(name, parameter.value, descriptor)
