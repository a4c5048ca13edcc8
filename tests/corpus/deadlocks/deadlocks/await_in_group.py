import rclpy
from rclpy.executors import MultiThreadedExecutor
from rclpy.node import Node
from std_srvs.srv import Empty


class Waiter(Node):
    """Many threads do not help: the timer and the client are in one group."""

    def __init__(self):
        super().__init__('waiter')
        self.client = self.create_client(Empty, 'clear')
        self.create_timer(1.0, self.on_timer)

    async def on_timer(self):
        self.get_logger().info('awaiting')
        await self.client.call_async(Empty.Request())
        self.get_logger().info('awaited')


def main():
    rclpy.init()
    executor = MultiThreadedExecutor()
    rclpy.spin(Waiter(), executor)
