"""The program talker: it publishes on `chatter` every second."""

from __future__ import annotations

from rclpy.node import Node
from std_msgs.msg import String

from edulaunch.ros.running import spin


class Talker(Node):
    """Publishes numbers from 0."""

    def __init__(self) -> None:
        super().__init__('talker')
        self.i = 0
        self.pub = self.create_publisher(String, 'chatter', 10)
        self.timer = self.create_timer(1.0, self.timer_callback)

    def timer_callback(self) -> None:
        """Publish the next number."""
        message = String(data=f'Hello World: {self.i}')
        self.i += 1
        self.get_logger().info(f'Publishing: "{message.data}"')
        self.pub.publish(message)


def main(args: list[str] | None = None) -> None:
    """Run the program."""
    spin(Talker, args)


if __name__ == '__main__':
    main()
