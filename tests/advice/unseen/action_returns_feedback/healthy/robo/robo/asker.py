import rclpy
from action_tutorials_interfaces.action import Fibonacci
from rclpy.action import ActionClient
from rclpy.node import Node


class Asker(Node):
    def __init__(self):
        super().__init__('asker')
        self.client = ActionClient(self, Fibonacci, 'count')
        self.client.wait_for_server()
        self.client.send_goal_async(Fibonacci.Goal(order=5)).add_done_callback(self.accepted)

    def accepted(self, future):
        future.result().get_result_async().add_done_callback(self.finished)


    def finished(self, future):
        self.get_logger().info(str(future.result().result.sequence))


def main():
    rclpy.init()
    rclpy.spin(Asker())
