"""The program publisher_member_function: a class whose timer publishes twice a second."""

from __future__ import annotations

from rclpy.node import Node
from std_msgs.msg import String

from edulaunch.ros.running import spin


class MinimalPublisher(Node):
    """Publishes numbers from 0 on `topic`."""

    def __init__(self) -> None:
        super().__init__('minimal_publisher')
        self.publisher_ = self.create_publisher(String, 'topic', 10)
        self.timer = self.create_timer(0.5, self.timer_callback)
        self.i = 0

    def timer_callback(self) -> None:
        """Publish the next number."""
        message = String(data=f'Hello World: {self.i}')
        self.publisher_.publish(message)
        self.get_logger().info(f'Publishing: "{message.data}"')
        self.i += 1


def main(args: list[str] | None = None) -> None:
    """Run the program."""
    spin(MinimalPublisher, args)


if __name__ == '__main__':
    main()
