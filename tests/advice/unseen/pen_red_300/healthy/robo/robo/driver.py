import rclpy
from turtlesim.srv import SetPen
from rclpy.node import Node


class Driver(Node):
    def __init__(self):
        super().__init__('driver')
        self.client = self.create_client(SetPen, '/turtle1/set_pen')
        self.client.wait_for_service()
        self.client.call_async(SetPen.Request(r=200, width=3))


def main():
    rclpy.init()
    rclpy.spin(Driver())
