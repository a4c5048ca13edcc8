"""The program fibonacci_action_server: it computes one Fibonacci number per second."""

from __future__ import annotations

import time

from action_tutorials_interfaces.action import Fibonacci
from rclpy.action import ActionServer
from rclpy.action.server import ServerGoalHandle
from rclpy.node import Node

from edulaunch.ros.running import spin


class FibonacciActionServer(Node):
    """Serves the action `fibonacci`."""

    def __init__(self) -> None:
        super().__init__('fibonacci_action_server')
        self._action_server = ActionServer(self, Fibonacci, 'fibonacci', self.execute_callback)

    def execute_callback(self, goal_handle: ServerGoalHandle) -> Fibonacci.Result:
        """Execute a goal."""
        self.get_logger().info('Executing goal...')
        feedback = Fibonacci.Feedback(partial_sequence=[0, 1])
        numbers = feedback.partial_sequence
        for index in range(1, goal_handle.request.order):
            numbers.append(numbers[index] + numbers[index - 1])
            self.get_logger().info(f'Feedback: {numbers}')
            goal_handle.publish_feedback(feedback)
            time.sleep(1)
        goal_handle.succeed()
        return Fibonacci.Result(sequence=numbers)


def main(args: list[str] | None = None) -> None:
    """Run the program."""
    spin(FibonacciActionServer, args)


if __name__ == '__main__':
    main()
