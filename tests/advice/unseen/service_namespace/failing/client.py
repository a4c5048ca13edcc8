import rclpy
from rclpy.node import Node
from turtlesim.srv import Spawn


class Client(Node):
    def __init__(self):
        super().__init__('client')
        self.client = self.create_client(Spawn, '/spawn')
        self.client.wait_for_service()
        future = self.client.call_async(Spawn.Request(x=3.0, y=3.0))
        future.add_done_callback(self.on_answer)

    def on_answer(self, future):
        self.get_logger().info(future.result().name)


def main():
    rclpy.init()
    node = Client()
    rclpy.spin(node)
    rclpy.shutdown()


if __name__ == '__main__':
    main()
