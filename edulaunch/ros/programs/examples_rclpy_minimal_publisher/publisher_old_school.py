"""The program publisher_old_school: it publishes in a loop, without spinning."""

from __future__ import annotations

from time import sleep

import rclpy
from std_msgs.msg import String

from edulaunch.ros.running import run

PERIOD_S = 0.5


def publish() -> None:
    """Publish a number and sleep, until ROS 2 is shut down."""
    node = rclpy.create_node('minimal_publisher')
    publisher = node.create_publisher(String, 'topic', 10)
    number = 0
    while rclpy.ok():
        message = String(data=f'Hello World: {number}')
        number += 1
        node.get_logger().info(f'Publishing: "{message.data}"')
        publisher.publish(message)
        sleep(PERIOD_S)


def main(args: list[str] | None = None) -> None:
    """Run the program."""
    run(publish, args)


if __name__ == '__main__':
    main()
