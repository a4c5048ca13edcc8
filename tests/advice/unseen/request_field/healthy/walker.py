import rclpy
from rclpy.node import Node
from turtlesim.srv import Spawn


class Walker(Node):
    def __init__(self):
        super().__init__('walker')
        self.client = self.create_client(Spawn, '/spawn')
        self.client.wait_for_service()
        request = Spawn.Request()
        request.x = 2.0
        request.y = 3.0
        request.name = 'second'
        self.future = self.client.call_async(request)


def main():
    rclpy.init()
    node = Walker()
    rclpy.spin(node)
    rclpy.shutdown()


main()
