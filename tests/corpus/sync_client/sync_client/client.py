import rclpy
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup
from rclpy.executors import MultiThreadedExecutor
from rclpy.node import Node
from example_interfaces.srv import AddTwoInts


class SyncClient(Node):
    def __init__(self):
        super().__init__('sync_client')
        self.cli = self.create_client(AddTwoInts, 'add', callback_group=MutuallyExclusiveCallbackGroup())
        self.n = 0
        self.timer = self.create_timer(1.0, self.on_timer)
        self.beat = self.create_timer(0.4, self.on_beat, MutuallyExclusiveCallbackGroup())

    def on_timer(self):
        self.n += 1
        self.get_logger().info('asking %d' % self.n)
        answer = self.cli.call(AddTwoInts.Request(a=self.n, b=40))
        self.get_logger().info('answer %d' % answer.sum)

    def on_beat(self):
        self.get_logger().info('beat')


def main(args=None):
    rclpy.init(args=args)
    node = SyncClient()
    executor = MultiThreadedExecutor()
    executor.add_node(node)
    executor.spin()
