"""The class through which /clock controls clocks (`use_sim_time`)."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from edulaunch.ros.passed_on import passed_on
from rclpy.clock import ROSClock
from rclpy.node_parts.core import is_node
from rclpy.parameter import Parameter
from rclpy.time import Time

if TYPE_CHECKING:
    from rcl_interfaces.msg import SetParametersResult

    from rclpy.impl.protocols import NodeProtocol
    from rclpy.subscription import Subscription

CLOCK_TOPIC = '/clock'
USE_SIM_TIME_NAME = 'use_sim_time'
NOT_BOOL = f'{USE_SIM_TIME_NAME} parameter set to something besides a bool'


class TimeSource:
    """Passes the time of /clock to the attached clocks while the source is active. The node's parameter use_sim_time activates
    it.

    :param node: the node that subscribes to /clock and has the parameter; None means that the node is attached later.
    """

    def __init__(self, *, node: NodeProtocol | None = None) -> None:
        self._clocks: list[ROSClock] = []
        self._node: NodeProtocol | None = None
        self._subscription: Subscription | None = None
        self._last_time: Time | None = None
        self._active = False
        if node is not None:
            self.attach_node(node)

    @property
    def ros_time_is_active(self) -> bool:
        """Whether /clock controls the clocks. The property can be set."""
        return self._active

    @ros_time_is_active.setter
    def ros_time_is_active(self, enabled: bool) -> None:
        if enabled == self._active:
            return
        self._active = enabled
        for clock in self._clocks:
            clock._set_ros_time_is_active(enabled)
        if enabled:
            self._subscribe()
        else:
            self._unsubscribe()

    def attach_node(self, node: NodeProtocol) -> None:
        """Subscribe to /clock through this node, and follow its parameter use_sim_time. Declare the parameter if necessary.

        :raises TypeError: when `node` is not a node.
        """
        if not is_node(node):
            raise TypeError('Node must be of type rclpy.node.Node')
        if self._node is not None:
            self.detach_node()
        self._node = node
        if not node.has_parameter(USE_SIM_TIME_NAME):
            node.declare_parameter(USE_SIM_TIME_NAME, False)
        value = node.get_parameter(USE_SIM_TIME_NAME)
        if value.type_ is Parameter.Type.BOOL:
            self.ros_time_is_active = value.value
        else:
            node.get_logger().error(f"Invalid type for parameter '{USE_SIM_TIME_NAME}' {value.type_!r} should be bool")
        node.add_on_set_parameters_callback(self._on_parameter_event)
        if self._active:
            self._subscribe()

    def detach_node(self) -> None:
        """Stop following /clock and the parameter. The clocks do not change."""
        self._unsubscribe()
        if self._node is not None:
            self._node.remove_on_set_parameters_callback(self._on_parameter_event)
        self._node = None

    def attach_clock(self, clock: Any) -> None:
        """Attach a clock, which then shows the last time of /clock. Raise ValueError unless it is a ROS clock."""
        if not isinstance(clock, ROSClock):
            raise ValueError('Only clocks with type ROS_TIME can be attached.')
        if self._last_time is not None:
            clock.set_ros_time_override(self._last_time)
        clock._set_ros_time_is_active(self._active)
        self._clocks.append(clock)

    def clock_callback(self, msg: Any) -> None:
        """Set the clocks to the time in a message of /clock."""
        self._last_time = Time.from_msg(msg.clock)
        for clock in self._clocks:
            clock.set_ros_time_override(self._last_time)

    def _subscribe(self) -> None:
        if self._node is None or self._subscription is not None:
            return
        from rosgraph_msgs.msg import Clock

        from rclpy.qos import QoSProfile, ReliabilityPolicy

        profile = QoSProfile(depth=1, reliability=ReliabilityPolicy.BEST_EFFORT)
        self._subscription = self._node.create_subscription(Clock, CLOCK_TOPIC, self.clock_callback, profile)

    def _unsubscribe(self) -> None:
        if self._node is not None and self._subscription is not None:
            self._node.destroy_subscription(self._subscription)
        self._subscription = None

    def _on_parameter_event(self, parameters: list[Parameter]) -> SetParametersResult:
        from rcl_interfaces.msg import SetParametersResult

        for parameter in parameters:
            if parameter.name == USE_SIM_TIME_NAME:
                if parameter.type_ is not Parameter.Type.BOOL:
                    if self._node is not None:
                        self._node.get_logger().error(NOT_BOOL)
                    return SetParametersResult(successful=False, reason=NOT_BOOL)
                self.ros_time_is_active = parameter.value
        return SetParametersResult(successful=True)


__getattr__ = passed_on(__name__)
