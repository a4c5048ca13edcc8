"""The program turtle_tf2_message_broadcaster, in which turtle3 drives in a circle and publishes stamped points."""

from __future__ import annotations

from typing import Any

from geometry_msgs.msg import PointStamped, Twist
from turtlesim.msg import Pose

from edulaunch.ros.running import spin
from turtle_tf2_py._spawning import SpawningNode


class PointPublisher(SpawningNode):
    """Publishes two messages for each pose of turtle3: a command to continue the circle, and a PointStamped in `world`.

    As in upstream, it creates another set of publishers and a subscription every second.
    """

    def __init__(self) -> None:
        super().__init__('turtle_tf2_message_broadcaster', 'turtle3')
        self._sets: list[Any] = []

    def on_step(self) -> None:
        """Create the publishers and the subscription for turtle3."""
        self._commands = self.create_publisher(Twist, 'turtle3/cmd_vel', 1)
        self._points = self.create_publisher(PointStamped, 'turtle3/turtle_point_stamped', 1)
        poses = self.create_subscription(Pose, 'turtle3/pose', self._on_pose, 1)
        self._sets.append((self._commands, self._points, poses))

    def _on_pose(self, pose: Pose) -> None:
        twist = Twist()
        twist.linear.x = 1.0
        twist.angular.z = 1.0
        self._commands.publish(twist)
        stamped = PointStamped()
        stamped.header.stamp = self.get_clock().now().to_msg()
        stamped.header.frame_id = 'world'
        stamped.point.x = pose.x
        stamped.point.y = pose.y
        self._points.publish(stamped)


def main() -> None:
    """Run the program until Ctrl-C or a shutdown."""
    spin(PointPublisher)


if __name__ == '__main__':
    main()
