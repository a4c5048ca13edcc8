"""The programs fibonacci_action_server, which computes Fibonacci numbers, and fibonacci_action_client, which requests ten."""

from __future__ import annotations

import time
from typing import Any

import rclpy
from action_msgs.msg import GoalStatus
from action_tutorials_interfaces.action import Fibonacci
from rclcpp_like import CppNode, program, spinning
from rclpy.action import ActionClient, ActionServer, CancelResponse, GoalResponse
from rclpy.action.server import ServerGoalHandle
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.executors import MultiThreadedExecutor
from rclpy.task import Future
from rclpy.timer import Timer

ORDER = 10
PATIENCE_S = 10.0


class FibonacciActionServer(CppNode):
    """Serves the action `fibonacci`, and executes each goal in a separate thread."""

    def __init__(self, **options: Any) -> None:
        super().__init__('fibonacci_action_server', **options)
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


class FibonacciActionClient(CppNode):
    """Sends a goal half a second after the start of the program."""

    def __init__(self, **options: Any) -> None:
        super().__init__('fibonacci_action_client', **options)
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

    def _on_feedback(self, message: Fibonacci.Impl.FeedbackMessage) -> None:
        self.get_logger().info(f'Next number in sequence received: {_spaced(message.feedback.partial_sequence)}')

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


fibonacci_action_client = spinning(FibonacciActionClient)
fibonacci_action_server = program(lambda: rclpy.spin(FibonacciActionServer(), executor=MultiThreadedExecutor()))
