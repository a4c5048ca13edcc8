import time
import rclpy
from rclpy.node import Node
from std_srvs.srv import Empty


class Cleaner(Node):
    def __init__(self):
        super().__init__('busy_cleaner')
        self.client = self.create_client(Empty, 'clear')
        self.create_timer(1.0, self.on_timer)

    def on_timer(self):
        self.get_logger().info('asking')
        future = self.client.call_async(Empty.Request())
        while not future.done():
            time.sleep(0.1)
        self.get_logger().info('answered')


def main():
    rclpy.init()
    rclpy.spin(Cleaner())
