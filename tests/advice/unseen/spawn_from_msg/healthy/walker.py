import rclpy
from rclpy.node import Node
from turtlesim.srv import Spawn


class Walker(Node):
    def __init__(self):
        super().__init__('walker')
        self.client = self.create_client(Spawn, '/spawn')


def main():
    rclpy.init()
    rclpy.spin(Walker())


if __name__ == '__main__':
    main()
