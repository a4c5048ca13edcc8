import rclpy
from rclpy.node import Node
from std_srvs.srv import Empty


class Cleaner(Node):
    def __init__(self):
        super().__init__('cleaner')
        self.client = self.create_client(Empty, 'clear')
        self.timer = self.create_timer(1.0, self.on_timer)

    def on_timer(self):
        self.get_logger().info('clearing')
        future = self.client.call_async(Empty.Request())
        rclpy.spin_until_future_complete(self, future)
        self.get_logger().info('cleared')


def main():
    rclpy.init()
    rclpy.spin(Cleaner())
    rclpy.shutdown()
