"""`use_sim_time`: letting /clock rule a node's clock."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from rclpy.clock import ROSClock
from rclpy.impl.passed_on import passed_on
from rclpy.parameter import Parameter, ParameterType
from rclpy.time import Time

if TYPE_CHECKING:
    from rcl_interfaces.msg import SetParametersResult

    from rclpy.node import Node
    from rclpy.subscription import Subscription

CLOCK_TOPIC = '/clock'
USE_SIM_TIME_NAME = 'use_sim_time'


class TimeSource:
    """Watches a node's parameter use_sim_time, and passes /clock on to clocks while it is true."""

    def __init__(self, *, node: Node) -> None:
        self._node = node
        self._clocks: list[ROSClock] = []
        self._subscription: Subscription | None = None
        self._active = False

    def declare_parameter(self) -> None:
        """Declare use_sim_time and obey its first value."""
        node = self._node
        if not node.has_parameter(USE_SIM_TIME_NAME):
            node.declare_parameter(USE_SIM_TIME_NAME, False)
        value = node.get_parameter(USE_SIM_TIME_NAME)
        if value.type_ is ParameterType.BOOL:
            self._set_active(value.value)
        else:
            node.get_logger().error(f"Invalid type for parameter '{USE_SIM_TIME_NAME}' {value.type_!r} should be bool")
        node.add_on_set_parameters_callback(self._on_parameter_event)

    @property
    def ros_time_is_active(self) -> bool:
        """Whether /clock rules."""
        return self._active

    def attach_clock(self, clock: Any) -> None:
        """Let the time source rule this clock too. Raises ValueError unless it is a ROS clock."""
        if not isinstance(clock, ROSClock):
            raise ValueError('Only clocks with type ROS_TIME can be attached.')
        clock._set_ros_time_is_active(self._active)
        self._clocks.append(clock)

    def detach_node(self) -> None:
        """Listen to /clock no more."""
        self._set_active(False)

    def _set_active(self, active: bool) -> None:
        if active == self._active:
            return
        self._active = active
        for clock in self._clocks:
            clock._set_ros_time_is_active(active)
        if active:
            self._subscribe()
        elif self._subscription is not None:
            self._node.destroy_subscription(self._subscription)
            self._subscription = None

    def _subscribe(self) -> None:
        from rosgraph_msgs.msg import Clock

        from rclpy.qos import QoSProfile, ReliabilityPolicy

        profile = QoSProfile(depth=1, reliability=ReliabilityPolicy.BEST_EFFORT)
        self._subscription = self._node.create_subscription(Clock, CLOCK_TOPIC, self._on_clock, profile)

    def _on_clock(self, message: Any) -> None:
        time = Time.from_msg(message.clock)
        for clock in self._clocks:
            clock.set_ros_time_override(time)

    def _on_parameter_event(self, parameters: list[Parameter]) -> SetParametersResult:
        from rcl_interfaces.msg import SetParametersResult

        for parameter in parameters:
            if parameter.name == USE_SIM_TIME_NAME:
                if parameter.type_ is not ParameterType.BOOL:
                    self._node.get_logger().error(f'{USE_SIM_TIME_NAME} parameter set to something besides a bool')
                    return SetParametersResult(
                        successful=False, reason=f'{USE_SIM_TIME_NAME} parameter set to something besides a bool'
                    )
                self._set_active(parameter.value)
        return SetParametersResult(successful=True)


__getattr__ = passed_on(
    __name__,
    {
        'rclpy.clock_type': 'ClockType',
        'typing': 'List Optional Set',
        'rclpy.qos': 'QoSProfile ReliabilityPolicy',
        'rcl_interfaces.msg': 'SetParametersResult',
    },
)
