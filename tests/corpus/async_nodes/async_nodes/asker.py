import rclpy
from rclpy.node import Node
from rclpy.task import Future
from std_msgs.msg import String
from example_interfaces.srv import AddTwoInts


class Asker(Node):
    def __init__(self):
        super().__init__('asker')
        self.cli = self.create_client(AddTwoInts, 'chained_add')

    async def ask(self, a, b):
        future = self.cli.call_async(AddTwoInts.Request(a=a, b=b))
        self.get_logger().info('asked')
        result = await future
        self.get_logger().info('got %d' % result.sum)
        return result.sum


def main():
    rclpy.init()
    node = Asker()
    while not node.cli.wait_for_service(timeout_sec=1.0):
        node.get_logger().info('waiting')
    executor = rclpy.executors.SingleThreadedExecutor()
    executor.add_node(node)
    task = executor.create_task(node.ask(2, 3))
    executor.spin_until_future_complete(task)
    print('sum', task.result())
    rclpy.shutdown()
