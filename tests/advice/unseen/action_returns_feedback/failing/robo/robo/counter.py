import rclpy
from action_tutorials_interfaces.action import Fibonacci
from rclpy.action import ActionServer
from rclpy.node import Node


class Counter(Node):
    def __init__(self):
        super().__init__('counter')
        self.server = ActionServer(self, Fibonacci, 'count', self.execute)

    def execute(self, goal_handle):
        feedback = Fibonacci.Feedback()
        feedback.partial_sequence = [0, 1]
        for index in range(1, goal_handle.request.order):
            feedback.partial_sequence.append(feedback.partial_sequence[index] + feedback.partial_sequence[index - 1])
            goal_handle.publish_feedback(feedback)
        goal_handle.succeed()
        return feedback


def main():
    rclpy.init()
    rclpy.spin(Counter())
