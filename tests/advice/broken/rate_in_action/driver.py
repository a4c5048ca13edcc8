import rclpy
from example_interfaces.action import Fibonacci
from rclpy.action import ActionClient, ActionServer
from rclpy.node import Node


class Counter(Node):
    def __init__(self):
        super().__init__('counter')
        self.server = ActionServer(self, Fibonacci, 'fibonacci', self.execute)
        self.client = ActionClient(self, Fibonacci, 'fibonacci')
        self.client.send_goal_async(Fibonacci.Goal(order=3))

    def execute(self, goal_handle):
        rate = self.create_rate(2)
        for _ in range(3):
            rate.sleep()
        goal_handle.succeed()
        return Fibonacci.Result()


rclpy.init()
rclpy.spin(Counter())
