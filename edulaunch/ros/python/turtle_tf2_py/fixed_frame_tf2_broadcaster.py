"""The program fixed_frame_tf2_broadcaster, which broadcasts the frame carrot1, two metres to the left of turtle1."""

from __future__ import annotations

from geometry_msgs.msg import TransformStamped
from rclpy.node import Node
from tf2_ros import TransformBroadcaster

from edulaunch.ros.running import spin

PERIOD_S = 0.1


class CarrotPublisher(Node):
    """Broadcasts turtle1 -> carrot1 ten times a second, at the position that :meth:`place` returns."""

    def __init__(self, node_name: str) -> None:
        super().__init__(node_name)
        self._broadcaster = TransformBroadcaster(self)
        self._timer = self.create_timer(PERIOD_S, self._on_timer)

    def place(self, seconds: int) -> tuple[float, float]:
        """Return x and y of the carrot in the turtle's frame, in metres, at the node's time in whole `seconds`."""
        return 0.0, 2.0

    def _on_timer(self) -> None:
        now = self.get_clock().now()
        stamped = TransformStamped()
        stamped.header.stamp = now.to_msg()
        stamped.header.frame_id = 'turtle1'
        stamped.child_frame_id = 'carrot1'
        translation = stamped.transform.translation
        translation.x, translation.y = self.place(now.seconds_nanoseconds()[0])
        self._broadcaster.sendTransform(stamped)


def main() -> None:
    """Run the program until Ctrl-C or a shutdown."""
    spin(lambda: CarrotPublisher('fixed_frame_tf2_broadcaster'))


if __name__ == '__main__':
    main()
