import rclpy
from turtlesim.srv import Spawn
from rclpy.node import Node


class Driver(Node):
    def __init__(self):
        super().__init__('driver')
        self.client = self.create_client(Spawn, '/spawn')
        self.client.wait_for_service()
        future = self.client.call_async(Spawn.Request(x=2.0, y=2.0, name='leo'))
        while not future.done():
            self.get_logger().info('waiting', throttle_duration_sec=1.0)
        self.get_logger().info(future.result().name)


def main():
    rclpy.init()
    rclpy.spin(Driver())
