"""The common parts of the servers: the node, its replies, and the work on one goal."""

from __future__ import annotations

import time
from typing import Any

from example_interfaces.action import Fibonacci
from rclpy.action import ActionServer, CancelResponse, GoalResponse
from rclpy.action.server import ServerGoalHandle
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.executors import MultiThreadedExecutor
from rclpy.node import Node

from edulaunch.ros.running import run

STEP_S = 1.0


class MinimalActionServer(Node):
    """Serves the action `fibonacci`. Computing a number takes one second.

    :param options: further callbacks of the ActionServer.
    """

    def __init__(self, **options: Any) -> None:
        super().__init__('minimal_action_server')
        self._action_server = ActionServer(
            self,
            Fibonacci,
            'fibonacci',
            execute_callback=self.execute_callback,
            callback_group=ReentrantCallbackGroup(),
            goal_callback=self.goal_callback,
            cancel_callback=self.cancel_callback,
            **options,
        )

    def destroy_node(self) -> None:
        """Destroy the action server and the node."""
        self._action_server.destroy()
        super().destroy_node()

    def goal_callback(self, goal_request: Fibonacci.Goal) -> GoalResponse:
        """Accept every goal."""
        self.get_logger().info('Received goal request')
        return GoalResponse.ACCEPT

    def cancel_callback(self, goal_handle: ServerGoalHandle) -> CancelResponse:
        """Accept every cancellation."""
        self.get_logger().info('Received cancel request')
        return CancelResponse.ACCEPT

    def execute_callback(self, goal_handle: ServerGoalHandle) -> Fibonacci.Result:
        """Execute a goal: compute one number per second, and publish each as feedback."""
        self.get_logger().info('Executing goal...')
        feedback = Fibonacci.Feedback(sequence=[0, 1])
        for index in range(1, goal_handle.request.order):
            if not goal_handle.is_active:
                self.get_logger().info('Goal aborted')
                return Fibonacci.Result()
            if goal_handle.is_cancel_requested:
                goal_handle.canceled()
                self.get_logger().info('Goal canceled')
                return Fibonacci.Result()
            feedback.sequence.append(feedback.sequence[index] + feedback.sequence[index - 1])
            self.get_logger().info(f'Publishing feedback: {feedback.sequence}')
            goal_handle.publish_feedback(feedback)
            time.sleep(STEP_S)
        return self.succeed(goal_handle, feedback)

    def succeed(self, goal_handle: ServerGoalHandle, feedback: Fibonacci.Feedback) -> Fibonacci.Result:
        """Mark a goal as succeeded. Return a result with the numbers that were published as feedback."""
        goal_handle.succeed()
        self.get_logger().info(f'Returning result: {feedback.sequence}')
        return Fibonacci.Result(sequence=feedback.sequence)


def serve(make_server: type[MinimalActionServer], args: list[str] | None) -> None:
    """Spin a server with several threads, so that a goal can be cancelled while the server executes it."""

    def body() -> None:
        executor = MultiThreadedExecutor()
        server = make_server()
        try:
            executor.add_node(server)
            executor.spin()
        finally:
            server.destroy_node()

    run(body, args)
