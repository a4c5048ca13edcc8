"""The program fibonacci_action_server: counts Fibonacci numbers, one a second."""

from __future__ import annotations

import sys
import time

import rclpy
from action_tutorials_interfaces.action import Fibonacci
from rclcpp_like import CppNode, run_program
from rclpy.action import ActionServer, CancelResponse, GoalResponse
from rclpy.action.server import ServerGoalHandle
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.executors import MultiThreadedExecutor


class FibonacciActionServer(CppNode):
    """Serves `fibonacci`; works on each goal in a thread of its own."""

    def __init__(self) -> None:
        super().__init__('fibonacci_action_server')
        self._server = ActionServer(
            self,
            Fibonacci,
            'fibonacci',
            execute_callback=self._execute,
            goal_callback=self._on_goal,
            cancel_callback=self._on_cancel,
            callback_group=ReentrantCallbackGroup(),
        )

    def _on_goal(self, goal: Fibonacci.Goal) -> GoalResponse:
        self.get_logger().info(f'Received goal request with order {goal.order}')
        return GoalResponse.ACCEPT

    def _on_cancel(self, goal_handle: ServerGoalHandle) -> CancelResponse:
        self.get_logger().info('Received request to cancel goal')
        return CancelResponse.ACCEPT

    def _execute(self, goal_handle: ServerGoalHandle) -> Fibonacci.Result:
        self.get_logger().info('Executing goal')
        feedback = Fibonacci.Feedback(partial_sequence=[0, 1])
        numbers = feedback.partial_sequence
        for index in range(1, goal_handle.request.order):
            if goal_handle.is_cancel_requested:
                goal_handle.canceled()
                self.get_logger().info('Goal canceled')
                return Fibonacci.Result(sequence=numbers)
            numbers.append(numbers[index] + numbers[index - 1])
            goal_handle.publish_feedback(feedback)
            self.get_logger().info('Publish feedback')
            time.sleep(1.0)
        goal_handle.succeed()
        self.get_logger().info('Goal succeeded')
        return Fibonacci.Result(sequence=numbers)


def main() -> None:
    """Run the program."""
    sys.exit(run_program(lambda: rclpy.spin(FibonacciActionServer(), executor=MultiThreadedExecutor())))


if __name__ == '__main__':
    main()
