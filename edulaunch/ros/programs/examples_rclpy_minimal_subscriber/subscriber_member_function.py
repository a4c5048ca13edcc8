"""The program subscriber_member_function: a class that logs each message."""

from __future__ import annotations

from rclpy.node import Node
from std_msgs.msg import String

from edulaunch.ros.running import spin


class MinimalSubscriber(Node):
    """Subscribes to `topic`, and logs each message."""

    def __init__(self) -> None:
        super().__init__('minimal_subscriber')
        self.subscription = self.create_subscription(String, 'topic', self.listener_callback, 10)

    def listener_callback(self, msg: String) -> None:
        """Log a message."""
        self.get_logger().info(f'I heard: "{msg.data}"')


def main(args: list[str] | None = None) -> None:
    """Run the program."""
    spin(MinimalSubscriber, args)


if __name__ == '__main__':
    main()
