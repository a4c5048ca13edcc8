import rclpy
from rclpy.node import Node
from turtlesim.srv import TeleportAbsolute


class Client(Node):
    def __init__(self):
        super().__init__('client')
        self.client = self.create_client(TeleportAbsolute, '/turtle/teleport_absolute')
        self.client.wait_for_service()
        future = self.client.call_async(TeleportAbsolute.Request(x=3.0, y=3.0))
        future.add_done_callback(self.on_answer)

    def on_answer(self, future):
        self.get_logger().info('done' if future.done() else '')


def main():
    rclpy.init()
    node = Client()
    rclpy.spin(node)
    rclpy.shutdown()


if __name__ == '__main__':
    main()
