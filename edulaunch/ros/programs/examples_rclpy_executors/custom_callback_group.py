"""The program custom_callback_group: a custom callback group that limits how often a timer runs."""

from __future__ import annotations

from typing import Any

from rclpy.callback_groups import CallbackGroup
from rclpy.node import Node
from std_msgs.msg import String

from edulaunch.ros.running import spin


class ThrottledCallbackGroup(CallbackGroup):
    """Delays callbacks when too many have run. A timer resets the number of allowed callbacks."""

    def __init__(self, node: Node) -> None:
        super().__init__()
        self.timer = node.create_timer(0.5, self.timer_callback)
        self.bucket = 10
        self.bucket_max = 10

    def can_execute(self, entity: Any) -> bool:
        """Return whether another callback is allowed."""
        return self.bucket > 0

    def beginning_execution(self, entity: Any) -> bool:
        """Reduce the number of allowed callbacks."""
        if not self.bucket:
            return False
        self.bucket -= 1
        return True

    def ending_execution(self, entity: Any) -> None:
        """Do nothing, because only the timer increases the number of allowed callbacks."""

    def timer_callback(self) -> None:
        """Reset the number of allowed callbacks when it is 0."""
        if not self.bucket:
            self.bucket = self.bucket_max


class ThrottledTalker(Node):
    """A node with a fast timer in a throttled group."""

    def __init__(self) -> None:
        super().__init__('intermittent_talker')
        self.i = 0
        self.pub = self.create_publisher(String, 'chatter', 10)
        self.group = ThrottledCallbackGroup(self)
        self.timer = self.create_timer(0.1, self.timer_callback, callback_group=self.group)

    def timer_callback(self) -> None:
        """Publish the next number."""
        message = String(data=f'Hello World: {self.i}')
        self.i += 1
        self.get_logger().info(f'Publishing: "{message.data}"')
        self.pub.publish(message)


def main(args: list[str] | None = None) -> None:
    """Run the program."""
    spin(ThrottledTalker, args)


if __name__ == '__main__':
    main()
