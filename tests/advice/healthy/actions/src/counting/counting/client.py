import rclpy
from example_interfaces.action import Fibonacci
from rclpy.action import ActionClient
from rclpy.node import Node


class Counting(Node):
    def __init__(self):
        super().__init__('counting')
        self.client = ActionClient(self, Fibonacci, 'fibonacci')
        self.client.wait_for_server()
        self.future = self.client.send_goal_async(Fibonacci.Goal(order=4))


def main():
    rclpy.init()
    node = Counting()
    rclpy.spin_until_future_complete(node, node.future)
    rclpy.spin(node)
