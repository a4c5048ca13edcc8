import rclpy
from rclpy.node import Node
from turtlesim.srv import SetPen


class Client(Node):
    def __init__(self):
        super().__init__('client')
        self.client = self.create_client(SetPen, '/set_pen')
        self.client.wait_for_service()
        future = self.client.call_async(SetPen.Request(r=255, width=4))
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
