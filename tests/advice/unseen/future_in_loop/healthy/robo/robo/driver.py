import rclpy
from turtlesim.srv import Spawn
from rclpy.node import Node


class Driver(Node):
    def __init__(self):
        super().__init__('driver')
        self.client = self.create_client(Spawn, '/spawn')
        self.client.wait_for_service()
        future = self.client.call_async(Spawn.Request(x=2.0, y=2.0, name='leo'))
        future.add_done_callback(self.born)

    def born(self, future):
        self.get_logger().info(future.result().name)


def main():
    rclpy.init()
    rclpy.spin(Driver())
