"""The program static_turtle_tf2_broadcaster, which broadcasts a static frame from seven command-line arguments."""

from __future__ import annotations

import sys
from math import cos, sin

from geometry_msgs.msg import TransformStamped
from rclpy.logging import get_logger
from rclpy.node import Node
from rclpy.utilities import remove_ros_args
from tf2_ros import StaticTransformBroadcaster

from edulaunch.ros.running import spin


def quaternion_from_euler(roll: float, pitch: float, yaw: float) -> tuple[float, float, float, float]:
    """Return the quaternion (x, y, z, w) of rotations about the fixed axes x, then y, then z. Angles are in radians."""
    sr, cr = sin(roll / 2.0), cos(roll / 2.0)
    sp, cp = sin(pitch / 2.0), cos(pitch / 2.0)
    sy, cy = sin(yaw / 2.0), cos(yaw / 2.0)
    return (sr * cp * cy - cr * sp * sy, cr * sp * cy + sr * cp * sy, cr * cp * sy - sr * sp * cy, cr * cp * cy + sr * sp * sy)


USAGE = (
    'Invalid number of parameters. Usage: \n'
    '$ ros2 run turtle_tf2_py static_turtle_tf2_broadcaster child_frame_name x y z roll pitch yaw'
)


class StaticFramePublisher(Node):
    """Broadcasts the transform world -> child once. Late subscriptions receive it, too."""

    def __init__(self, child: str, numbers: list[float]) -> None:
        super().__init__('static_turtle_tf2_broadcaster')
        self._broadcaster = StaticTransformBroadcaster(self)
        stamped = TransformStamped()
        stamped.header.stamp = self.get_clock().now().to_msg()
        stamped.header.frame_id = 'world'
        stamped.child_frame_id = child
        place, turn = stamped.transform.translation, stamped.transform.rotation
        place.x, place.y, place.z = numbers[:3]
        turn.x, turn.y, turn.z, turn.w = quaternion_from_euler(*numbers[3:])
        self._broadcaster.sendTransform(stamped)


def main() -> None:
    """Run the program. Exit with 1 for a wrong number of arguments, and with 2 for the child name 'world'."""
    arguments = remove_ros_args(sys.argv)[1:]
    if len(arguments) != 7:
        get_logger('static_turtle_tf2_broadcaster').info(USAGE)
        sys.exit(1)
    if arguments[0] == 'world':
        get_logger('static_turtle_tf2_broadcaster').info('Your static turtle name cannot be "world"')
        sys.exit(2)
    numbers = [float(argument) for argument in arguments[1:]]
    spin(lambda: StaticFramePublisher(arguments[0], numbers))


if __name__ == '__main__':
    main()
