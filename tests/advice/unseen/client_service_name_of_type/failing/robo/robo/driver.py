import rclpy
from turtlesim.srv import TeleportAbsolute
from rclpy.node import Node


class Driver(Node):
    def __init__(self):
        super().__init__('driver')
        self.client = self.create_client(TeleportAbsolute, '/turtle1/teleport')
        while not self.client.wait_for_service(timeout_sec=1.0):
            self.get_logger().info('waiting')
        self.client.call_async(TeleportAbsolute.Request(x=2.0, y=2.0))


def main():
    rclpy.init()
    rclpy.spin(Driver())
