import sys
import time
import rclpy
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup, ReentrantCallbackGroup
from rclpy.executors import MultiThreadedExecutor
from rclpy.node import Node


class Timers(Node):
    def __init__(self, kind, seconds):
        super().__init__('timers_' + kind)
        self.seconds = seconds
        if kind == 'same':
            group1 = group2 = MutuallyExclusiveCallbackGroup()
        elif kind == 'own':
            group1, group2 = MutuallyExclusiveCallbackGroup(), MutuallyExclusiveCallbackGroup()
        else:
            group1 = group2 = ReentrantCallbackGroup()
        self.timer1 = self.create_timer(1.0, self.one, callback_group=group1)
        self.timer2 = self.create_timer(1.0, self.two, callback_group=group2)

    def one(self):
        self.get_logger().info('one begins')
        time.sleep(self.seconds)
        self.get_logger().info('one ends')

    def two(self):
        self.get_logger().info('two begins')
        time.sleep(0.25)
        self.get_logger().info('two ends')


def main(args=None):
    rclpy.init(args=args)
    node = Timers(sys.argv[1], float(sys.argv[2]))
    executor = MultiThreadedExecutor(num_threads=4)
    executor.add_node(node)
    try:
        executor.spin()
    except KeyboardInterrupt:
        pass
    finally:
        executor.shutdown()
        node.destroy_node()
