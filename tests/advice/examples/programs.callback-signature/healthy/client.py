import rclpy
from rclpy.node import Node
from example_interfaces.srv import AddTwoInts


class Client(Node):
    def __init__(self):
        super().__init__('asker')
        self.client = self.create_client(AddTwoInts, 'add_two_ints')
        while not self.client.wait_for_service(timeout_sec=1.0):
            self.get_logger().info('waiting')

    def ask(self, a, b):
        request = AddTwoInts.Request()
        request.a = a
        request.b = b
        future = self.client.call_async(request)
        rclpy.spin_until_future_complete(self, future)
        return future.result()


def main():
    rclpy.init()
    node = Client()
    answer = node.ask(2, 3)
    node.get_logger().info(f'sum {answer.sum}')
    node.destroy_node()
    rclpy.shutdown()


if __name__ == '__main__':
    main()
