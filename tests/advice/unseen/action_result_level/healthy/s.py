import rclpy
from rclpy.node import Node
from rclpy.action import ActionClient, ActionServer
from example_interfaces.action import Fibonacci


class Mine(Node):
    def __init__(self):
        super().__init__('server')
        self.server = ActionServer(self, Fibonacci, 'fibonacci', self.execute)

    def execute(self, goal_handle):
        goal_handle.succeed()
        result = Fibonacci.Result()
        result.sequence = [0, 1]
        return result

def main():
    rclpy.init()
    node = Mine()
    rclpy.spin(node)


main()
