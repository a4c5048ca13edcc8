import rclpy
from rclpy.node import Node
from rclpy.action import ActionClient
from example_interfaces.action import Fibonacci


class Ask(Node):

    def __init__(self):
        super().__init__('ask')
        self.client = ActionClient(self, Fibonacci, 'fibonacci')
        self.client.wait_for_server()
        self.client.send_goal_async(Fibonacci.Goal(order=4)).add_done_callback(self.done)

    def done(self, future):
        future.result().get_result_async().add_done_callback(lambda f: self.get_logger().info(str(f.result().result.sequence)))


def main(args=None):
    rclpy.init(args=args)
    node = Ask()
    rclpy.spin(node)
    rclpy.shutdown()


if __name__ == '__main__':
    main()
