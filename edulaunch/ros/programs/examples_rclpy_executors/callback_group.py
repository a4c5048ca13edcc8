"""The program callback_group: two timers in one group, which never run at the same time, and a listener."""

from __future__ import annotations

from rclpy.callback_groups import MutuallyExclusiveCallbackGroup
from rclpy.executors import MultiThreadedExecutor
from rclpy.node import Node
from std_msgs.msg import String

from edulaunch.ros.running import run
from examples_rclpy_executors.listener import Listener


class DoubleTalker(Node):
    """Publishes from two timers with a common counter, so the timers must not run at the same time."""

    def __init__(self) -> None:
        super().__init__('double_talker')
        self.i = 0
        self.pub = self.create_publisher(String, 'chatter', 10)
        self.group = MutuallyExclusiveCallbackGroup()
        self.timer = self.create_timer(1.0, self.timer_callback, callback_group=self.group)
        self.timer2 = self.create_timer(0.5, self.timer_callback, callback_group=self.group)

    def timer_callback(self) -> None:
        """Publish the next number."""
        message = String(data=f'Hello World: {self.i}')
        self.i += 1
        self.get_logger().info(f'Publishing: "{message.data}"')
        self.pub.publish(message)


def work() -> None:
    """Spin both nodes with four threads."""
    executor = MultiThreadedExecutor(num_threads=4)
    executor.add_node(DoubleTalker())
    executor.add_node(Listener())
    executor.spin()


def main(args: list[str] | None = None) -> None:
    """Run the program."""
    run(work, args)


if __name__ == '__main__':
    main()
