import rclpy
from rclpy.node import Node
from turtlesim.srv import Kill


class Hasty(Node):
    """Does not wait for the service: turtlesim starts later."""

    def __init__(self):
        super().__init__('hasty')
        self.client = self.create_client(Kill, 'kill')
        self.client.call_async(Kill.Request(name='turtle1')).add_done_callback(
            lambda future: self.get_logger().info('killed'))


def main():
    rclpy.init()
    rclpy.spin(Hasty())
