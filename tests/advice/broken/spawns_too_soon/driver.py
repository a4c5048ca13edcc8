import rclpy
from rclpy.node import Node
from turtlesim.srv import Spawn


class Spawner(Node):
    def __init__(self):
        super().__init__('spawner')
        self.client = self.create_client(Spawn, 'spawn')
        request = Spawn.Request()
        request.x = 2.0
        request.y = 8.0
        request.theta = 0.0
        request.name = 'turtle2'
        self.future = self.client.call_async(request)


def main():
    rclpy.init()
    node = Spawner()
    rclpy.spin_until_future_complete(node, node.future)
    rclpy.shutdown()


if __name__ == '__main__':
    main()
