import rclpy
from example_interfaces.action import Fibonacci
from rclpy.action import ActionServer
from rclpy.node import Node


class Counter(Node):
    def __init__(self):
        super().__init__('counter')
        self.server = ActionServer(self, Fibonacci, 'count', self.execute)

    def execute(self, goal_handle):
        feedback = Fibonacci.Feedback()
        feedback.sequence = [0, 1]
        for index in range(1, goal_handle.request.order):
            feedback.sequence.append(feedback.sequence[index] + feedback.sequence[index - 1])
            goal_handle.publish_feedback(feedback)
        goal_handle.succeed()
        result = Fibonacci.Result()
        result.sequence = feedback.sequence
        return result


def main():
    rclpy.init()
    rclpy.spin(Counter())
