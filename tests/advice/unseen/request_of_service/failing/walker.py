import rclpy
from rclpy.node import Node
from turtlesim.srv import Spawn


class Walker(Node):
    def __init__(self):
        super().__init__('walker')
        self.client = self.create_client(Spawn, 'spawn')
        self.timer = self.create_timer(1.0, self.tick)

    def tick(self):
        self.timer.cancel()
        self.client.call_async(Spawn())


def main():
    rclpy.init()
    rclpy.spin(Walker())


main()
