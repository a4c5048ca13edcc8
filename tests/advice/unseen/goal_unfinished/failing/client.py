import rclpy
from example_interfaces.action import Fibonacci
from rclpy.action import ActionClient
from rclpy.node import Node


class Asker(Node):
    def __init__(self):
        super().__init__('asker')
        self.client = ActionClient(self, Fibonacci, 'fibonacci')
        self.client.wait_for_server()
        future = self.client.send_goal_async(Fibonacci.Goal(order=5))
        future.add_done_callback(self.on_accepted)

    def on_accepted(self, future):
        handle = future.result()
        handle.get_result_async().add_done_callback(self.on_result)

    def on_result(self, future):
        self.get_logger().info(f'result {list(future.result().result.sequence)}')


def main():
    rclpy.init()
    node = Asker()
    rclpy.spin(node)
    rclpy.shutdown()


if __name__ == '__main__':
    main()
