import math

import rclpy
from rclpy.node import Node
from turtlesim.srv import TeleportAbsolute


class Jumper(Node):
    def __init__(self):
        super().__init__('jumper')
        self.client = self.create_client(TeleportAbsolute, '/turtle1/teleport_absolute')
        self.client.wait_for_service()
        self.create_timer(2.0, self.jump)

    def jump(self):
        req = TeleportAbsolute.Request()
        req.x = 2.0
        req.y = 2.0
        req.theta = math.radians(90)
        self.client.call_async(req)


def main():
    rclpy.init()
    rclpy.spin(Jumper())
