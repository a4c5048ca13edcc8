import rclpy
from rclpy.node import Node
from std_srvs.srv import Empty


class Cleaner(Node):
    def __init__(self):
        super().__init__('sync_cleaner')
        self.client = self.create_client(Empty, 'clear')
        self.create_timer(1.0, self.on_timer)

    def on_timer(self):
        self.get_logger().info('calling')
        self.client.call(Empty.Request())
        self.get_logger().info('called')


def main():
    rclpy.init()
    rclpy.spin(Cleaner())
