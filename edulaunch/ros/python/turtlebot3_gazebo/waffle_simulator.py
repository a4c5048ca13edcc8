"""The program waffle_simulator, a robot in place of Gazebo. It follows the commands on /cmd_vel, and publishes /odom and tf."""

from __future__ import annotations

from math import cos, sin
from typing import Any

from geometry_msgs.msg import TransformStamped, Twist, TwistStamped
from nav_msgs.msg import Odometry
from rclcpp_like import CppNode, spinning
from tf2_ros import TransformBroadcaster

from edulaunch.engine.worlds.planar_robot import PlanarRobot
from edulaunch.ros.node_facts import core_of

ODOMETRY_HZ = 30.0


class WaffleSimulator(CppNode):
    """A Waffle. The parameters x_pose, y_pose (metres) and yaw (radians) set its initial pose.

    TurtleBot3 accepts TwistStamped since Jazzy, and accepted Twist before. `enable_stamped_cmd_vel` sets the type of a real
    robot. This robot accepts both types, so that old and new programs can drive it. If the parameter is true (the default), a
    plain Twist causes one warning. If it is false, a TwistStamped causes the warning.
    """

    def __init__(self) -> None:
        super().__init__('turtlebot3_diff_drive')
        x, y, yaw = (self.declare_parameter(name, 0.0).value for name in ('x_pose', 'y_pose', 'yaw'))
        self._expects_stamped = self.declare_parameter('enable_stamped_cmd_vel', True).value
        self._robot = PlanarRobot(x, y, yaw, self.get_clock().now().nanoseconds)
        core = core_of(self)
        core.takes_any_type = True
        kinds = [(TwistStamped, self._on_stamped), (Twist, self._on_plain)][:: 1 if self._expects_stamped else -1]
        self._create_for(*kinds[0])
        self._other: tuple[Any, Any] | None = kinds[1] if core.takes_any_type else None  # a real program has one type per topic
        self._commanders = 0
        self._odometry = self.create_publisher(Odometry, 'odom', 10)
        self._broadcaster = TransformBroadcaster(self)
        self._timer = self.create_timer(1.0 / ODOMETRY_HZ, self._on_timer)
        self.get_logger().info(f'Spawned waffle at x={x:.2f}, y={y:.2f}, yaw={yaw:.2f}')

    def _create_for(self, kind: Any, callback: Any) -> None:
        self.create_subscription(kind, 'cmd_vel', callback, 10)

    def _look_for_other(self) -> None:
        """Subscribe to the second type, too, as soon as a program publishes it."""
        if self._other is None:
            return
        count = self.count_publishers('cmd_vel')
        if count != self._commanders:
            self._commanders = count
            types = {info.topic_type for info in self.get_publishers_info_by_topic('cmd_vel')}
            if f'geometry_msgs/msg/{self._other[0].__name__}' in types:
                self._create_for(*self._other)
                self._other = None

    def _on_stamped(self, message: Any) -> None:
        self._drive(message.twist, 'TwistStamped', self._expects_stamped)

    def _on_plain(self, message: Any) -> None:
        self._drive(message, 'Twist', not self._expects_stamped)

    def _drive(self, twist: Any, type_name: str, expected: bool) -> None:
        if not expected:
            other = 'Twist' if type_name == 'TwistStamped' else 'TwistStamped'
            self.get_logger().warning(
                f'Following a geometry_msgs/msg/{type_name} on cmd_vel; a real TurtleBot3 set up like this '
                f'one expects geometry_msgs/msg/{other}',
                once=True,
            )
        self._robot.command(twist.linear.x, twist.angular.z, self.get_clock().now().nanoseconds)

    def _on_timer(self) -> None:
        self._look_for_other()
        robot = self._robot
        now = self.get_clock().now()
        robot.advance_to(now.nanoseconds)
        stamp = now.to_msg()
        turn = sin(robot.theta / 2.0), cos(robot.theta / 2.0)
        self._publish_odometry(stamp, *turn)
        self._publish_transform(stamp, *turn)

    def _publish_odometry(self, stamp: Any, z: float, w: float) -> None:
        message = Odometry()
        message.header.stamp = stamp
        message.header.frame_id = 'odom'
        message.child_frame_id = 'base_footprint'
        pose, twist = message.pose.pose, message.twist.twist
        pose.position.x, pose.position.y = self._robot.x, self._robot.y
        pose.orientation.z, pose.orientation.w = z, w
        twist.linear.x, twist.angular.z = self._robot.linear, self._robot.angular
        self._odometry.publish(message)

    def _publish_transform(self, stamp: Any, z: float, w: float) -> None:
        stamped = TransformStamped()
        stamped.header.stamp = stamp
        stamped.header.frame_id = 'odom'
        stamped.child_frame_id = 'base_footprint'
        place, turn = stamped.transform.translation, stamped.transform.rotation
        place.x, place.y = self._robot.x, self._robot.y
        turn.z, turn.w = z, w
        self._broadcaster.sendTransform(stamped)


main = spinning(WaffleSimulator)
