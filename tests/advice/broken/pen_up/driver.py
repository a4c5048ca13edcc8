import rclpy
from rclpy.node import Node
from turtlesim.srv import SetPen


class Spawner(Node):
    def __init__(self):
        super().__init__('spawner')
        self.client = self.create_client(SetPen, '/turtle1/set_pen')
        while not self.client.wait_for_service(timeout_sec=1.0):
            self.get_logger().info('service not available, waiting again...')
        request = SetPen.Request(r=255, g=0, b=0, width=4, off=1)
        self.future = self.client.call_async(request)


def main():
    rclpy.init()
    node = Spawner()
    rclpy.spin_until_future_complete(node, node.future)
    rclpy.shutdown()


if __name__ == '__main__':
    main()
