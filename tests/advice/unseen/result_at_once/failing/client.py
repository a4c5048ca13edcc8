import rclpy
from rclpy.node import Node
from std_srvs.srv import Trigger


class Client(Node):
    def __init__(self):
        super().__init__('client')
        self.client = self.create_client(Trigger, 'status')
        self.client.wait_for_service()
        future = self.client.call_async(Trigger.Request())
        self.get_logger().info(future.result().message)

    def on_answer(self, future):
        self.get_logger().info(future.result().message)


def main():
    rclpy.init()
    node = Client()
    rclpy.spin(node)
    rclpy.shutdown()


if __name__ == '__main__':
    main()
