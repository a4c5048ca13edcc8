import random
import rclpy
from random import choice
from rclpy.node import Node
import numpy as np
from turtlesim.srv import TeleportAbsolute


class Walker(Node):
    def __init__(self):
        super().__init__('walker')
        self.client = self.create_client(TeleportAbsolute, '/turtle1/teleport_absolute')
        while not self.client.wait_for_service(timeout_sec=1.0):
            self.get_logger().info('service not available, waiting again...')
        self.timer = self.create_timer(1, self.jump)
        self.rng = np.random.default_rng()

    def jump(self):
        request = TeleportAbsolute.Request()
        request.x = random.uniform(1, 10)
        request.y = float(random.randint(1, 10))
        request.theta = np.random.rand() * 3.14
        noise = self.rng.normal()
        self.get_logger().info('%s to (%.3f, %.1f) %.4f %.4f' % (
            choice(['jump', 'hop', 'leap']), request.x, request.y, request.theta, noise))
        self.client.call_async(request)


def main(args=None):
    rclpy.init(args=args)
    rclpy.spin(Walker())
