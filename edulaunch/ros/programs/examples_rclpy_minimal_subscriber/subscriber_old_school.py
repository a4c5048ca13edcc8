"""The program subscriber_old_school: it calls spin_once for each callback."""

from __future__ import annotations

import rclpy
from std_msgs.msg import String

from edulaunch.ros.running import run


def listen() -> None:
    """Call spin_once until ROS 2 is shut down."""
    node = rclpy.create_node('minimal_subscriber')

    def on_message(message: String) -> None:
        node.get_logger().info(f'I heard: "{message.data}"')

    node.create_subscription(String, 'topic', on_message, 10)
    while rclpy.ok():
        rclpy.spin_once(node)


def main(args: list[str] | None = None) -> None:
    """Run the program."""
    run(listen, args)


if __name__ == '__main__':
    main()
