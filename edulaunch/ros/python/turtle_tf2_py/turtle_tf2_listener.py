"""The program turtle_tf2_listener, which spawns turtle2 and drives it towards a frame."""

from __future__ import annotations

from math import atan2, hypot

from geometry_msgs.msg import Twist
from rclpy.time import Time
from tf2_ros import Buffer, TransformException, TransformListener

from edulaunch.ros.running import spin
from turtle_tf2_py._spawning import SpawningNode

FOLLOWER = 'turtle2'
TURN_GAIN = 1.0
DRIVE_GAIN = 0.5


class FrameListener(SpawningNode):
    """Looks up `target_frame` relative to turtle2 once a second, and drives turtle2 towards that frame."""

    def __init__(self) -> None:
        super().__init__('turtle_tf2_frame_listener', FOLLOWER)
        self._target = self.declare_parameter('target_frame', 'turtle1').get_parameter_value().string_value
        self._buffer = Buffer()
        self._listener = TransformListener(self._buffer, self)
        self._commands = self.create_publisher(Twist, f'{FOLLOWER}/cmd_vel', 1)

    def on_step(self) -> None:
        """Look the transform up, and publish a command."""
        try:
            found = self._buffer.lookup_transform(FOLLOWER, self._target, Time())
        except TransformException as error:
            self.get_logger().info(f'Could not transform {FOLLOWER} to {self._target}: {error}')
            return
        place = found.transform.translation
        twist = Twist()
        twist.angular.z = TURN_GAIN * atan2(place.y, place.x)
        twist.linear.x = DRIVE_GAIN * hypot(place.x, place.y)
        self._commands.publish(twist)


def main() -> None:
    """Run the program until Ctrl-C or a shutdown."""
    spin(FrameListener)


if __name__ == '__main__':
    main()
