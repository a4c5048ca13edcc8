"""The program param_circle.py, which drives a robot in a circle whose radius is a parameter."""

from __future__ import annotations

import rclpy
from geometry_msgs.msg import TwistStamped
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node

SPEED = 0.1  # m/s
PERIOD_S = 0.1


class ParamCircle(Node):
    """Drives in a circle. It reads `radius` (metres) for each command, so a change has an immediate effect."""

    def __init__(self) -> None:
        super().__init__('param_circle')
        self.declare_parameter('radius', 0.5)
        self._commands = self.create_publisher(TwistStamped, 'cmd_vel', 10)
        self._timer = self.create_timer(PERIOD_S, self._on_timer)

    def _on_timer(self) -> None:
        radius = self.get_parameter('radius').get_parameter_value().double_value
        command = TwistStamped()
        command.header.stamp = self.get_clock().now().to_msg()
        command.twist.linear.x = SPEED
        if radius != 0.0:
            command.twist.angular.z = SPEED / radius
            self.get_logger().info(f'Moving with radius: {radius:.2f} [m].', throttle_duration_sec=1.0)
        else:
            self.get_logger().warning('A circle of radius 0 cannot be driven; going straight ahead.', throttle_duration_sec=1.0)
        self._commands.publish(command)


def main() -> None:
    """Run the program until Ctrl-C or a shutdown."""
    try:
        rclpy.init()
        rclpy.spin(ParamCircle())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == '__main__':
    main()
