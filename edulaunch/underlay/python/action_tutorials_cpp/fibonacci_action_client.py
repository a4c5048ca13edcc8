"""The program fibonacci_action_client: asks for ten Fibonacci numbers, and ends."""

from __future__ import annotations

import sys

import rclpy
from action_msgs.msg import GoalStatus
from action_tutorials_interfaces.action import Fibonacci
from rclcpp_like import CppNode, run_program
from rclpy.action import ActionClient
from rclpy.task import Future
from rclpy.timer import Timer

ORDER = 10
PATIENCE_S = 10.0


class FibonacciActionClient(CppNode):
    """Sends its goal half a second after the start."""

    def __init__(self) -> None:
        super().__init__('fibonacci_action_client')
        self._client = ActionClient(self, Fibonacci, 'fibonacci')
        self._timer: Timer = self.create_wall_timer(0.5, self._send_goal)

    def _send_goal(self) -> None:
        self._timer.cancel()
        if not self._client.wait_for_server(timeout_sec=PATIENCE_S):
            self.get_logger().error('Action server not available after waiting')
            rclpy.shutdown()
            return
        self.get_logger().info('Sending goal')
        sent = self._client.send_goal_async(Fibonacci.Goal(order=ORDER), feedback_callback=self._on_feedback)
        sent.add_done_callback(self._on_answer)

    def _on_answer(self, future: Future) -> None:
        goal_handle = future.result()
        if not goal_handle.accepted:
            self.get_logger().error('Goal was rejected by server')
            return
        self.get_logger().info('Goal accepted by server, waiting for result')
        goal_handle.get_result_async().add_done_callback(self._on_result)

    def _on_feedback(self, told: Fibonacci.Impl.FeedbackMessage) -> None:
        self.get_logger().info(f'Next number in sequence received: {_spaced(told.feedback.partial_sequence)}')

    def _on_result(self, future: Future) -> None:
        answer = future.result()
        if answer.status == GoalStatus.STATUS_SUCCEEDED:
            self.get_logger().info(f'Result received: {_spaced(answer.result.sequence)}')
        else:
            aborted = answer.status == GoalStatus.STATUS_ABORTED
            self.get_logger().error('Goal was aborted' if aborted else 'Goal was canceled')
        rclpy.shutdown()


def _spaced(numbers: list[int]) -> str:
    return ''.join(f'{number} ' for number in numbers)


def main() -> None:
    """Run the program."""
    sys.exit(run_program(lambda: rclpy.spin(FibonacciActionClient())))


if __name__ == '__main__':
    main()
