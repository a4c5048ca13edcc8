"""The program listener: it logs each message on `chatter`."""

from __future__ import annotations

from rclpy.node import Node
from std_msgs.msg import String

from edulaunch.ros.running import spin


class Listener(Node):
    """Logs each message on `chatter`."""

    def __init__(self) -> None:
        super().__init__('listener')
        self.sub = self.create_subscription(String, 'chatter', self.chatter_callback, 10)

    def chatter_callback(self, msg: String) -> None:
        """Log a message."""
        self.get_logger().info(f'I heard: "{msg.data}"')


def main(args: list[str] | None = None) -> None:
    """Run the program."""
    spin(Listener, args)


if __name__ == '__main__':
    main()
