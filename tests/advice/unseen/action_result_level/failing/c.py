import rclpy
from rclpy.node import Node
from rclpy.action import ActionClient, ActionServer
from example_interfaces.action import Fibonacci


class Mine(Node):
    def __init__(self):
        super().__init__('asker')
        self.client = ActionClient(self, Fibonacci, 'fibonacci')
        self.client.wait_for_server()
        self.client.send_goal_async(Fibonacci.Goal(order=3)).add_done_callback(self.accepted)

    def accepted(self, future):
        future.result().get_result_async().add_done_callback(self.done)

    def done(self, future):
        self.get_logger().info(str(future.result().sequence))

def main():
    rclpy.init()
    node = Mine()
    rclpy.spin(node)


main()
