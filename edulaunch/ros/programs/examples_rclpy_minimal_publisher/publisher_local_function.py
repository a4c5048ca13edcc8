"""The program publisher_local_function: the callback of its timer is a nested function."""

from __future__ import annotations

import rclpy
from std_msgs.msg import String

from edulaunch.ros.running import run


def publish() -> None:
    """Spin a node whose timer publishes twice a second."""
    node = rclpy.create_node('minimal_publisher')
    publisher = node.create_publisher(String, 'topic', 10)
    number = 0

    def on_timer() -> None:
        nonlocal number
        message = String(data=f'Hello World: {number}')
        number += 1
        node.get_logger().info(f'Publishing: "{message.data}"')
        publisher.publish(message)

    node.create_timer(0.5, on_timer)
    rclpy.spin(node)


def main(args: list[str] | None = None) -> None:
    """Run the program."""
    run(publish, args)


if __name__ == '__main__':
    main()
