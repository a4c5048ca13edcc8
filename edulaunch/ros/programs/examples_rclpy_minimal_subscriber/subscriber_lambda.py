"""The program subscriber_lambda: its callback is a lambda expression."""

from __future__ import annotations

import rclpy
from std_msgs.msg import String

from edulaunch.ros.running import run


def listen() -> None:
    """Spin a node that logs each message."""
    node = rclpy.create_node('minimal_subscriber')
    node.create_subscription(String, 'topic', lambda message: node.get_logger().info(f'I heard: "{message.data}"'), 10)
    rclpy.spin(node)


def main(args: list[str] | None = None) -> None:
    """Run the program."""
    run(listen, args)


if __name__ == '__main__':
    main()
