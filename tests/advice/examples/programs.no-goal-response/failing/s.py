import rclpy
from rclpy.action import ActionClient, ActionServer, GoalResponse
from rclpy.node import Node
from example_interfaces.action import Fibonacci


class Both(Node):
    def __init__(self):
        super().__init__('fib_server')
        self.server = ActionServer(self, Fibonacci, 'fib', self.execute, goal_callback=self.check)

    def check(self, goal):
        return goal.order < 20

    def execute(self, handle):
        handle.succeed()
        return Fibonacci.Result(sequence=[0, 1, 1])


def main(args=None):
    rclpy.init(args=args)
    node = Both()
    rclpy.spin(node)
    rclpy.shutdown()


if __name__ == '__main__':
    main()
