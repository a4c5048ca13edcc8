"""The program server_not_composable: an action server written with functions instead of a class."""

from __future__ import annotations

import time
from functools import partial

import rclpy
from example_interfaces.action import Fibonacci
from rclpy.action import ActionServer, CancelResponse
from rclpy.action.server import ServerGoalHandle
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.executors import MultiThreadedExecutor
from rclpy.node import Node

from edulaunch.ros.running import run

STEP_S = 1.0


def cancel_callback(node: Node, goal_handle: ServerGoalHandle) -> CancelResponse:
    """Accept every cancellation."""
    node.get_logger().info('Received cancel request')
    return CancelResponse.ACCEPT


async def execute_callback(node: Node, goal_handle: ServerGoalHandle) -> Fibonacci.Result:
    """Execute a goal: compute one number per second, and publish each as feedback."""
    node.get_logger().info('Executing goal...')
    feedback = Fibonacci.Feedback(sequence=[0, 1])
    for index in range(1, goal_handle.request.order):
        if goal_handle.is_cancel_requested:
            goal_handle.canceled()
            node.get_logger().info('Goal canceled')
            return Fibonacci.Result()
        feedback.sequence.append(feedback.sequence[index] + feedback.sequence[index - 1])
        node.get_logger().info(f'Publishing feedback: {feedback.sequence}')
        goal_handle.publish_feedback(feedback)
        time.sleep(STEP_S)
    goal_handle.succeed()
    node.get_logger().info(f'Returning result: {feedback.sequence}')
    return Fibonacci.Result(sequence=feedback.sequence)


def serve() -> None:
    """Spin a node that serves `fibonacci`, with several threads."""
    node = rclpy.create_node('minimal_action_server')
    server = ActionServer(
        node,
        Fibonacci,
        'fibonacci',
        execute_callback=partial(execute_callback, node),
        cancel_callback=partial(cancel_callback, node),
        callback_group=ReentrantCallbackGroup(),
    )
    try:
        rclpy.spin(node, executor=MultiThreadedExecutor())
    finally:
        server.destroy()


def main(args: list[str] | None = None) -> None:
    """Run the program."""
    run(serve, args)


if __name__ == '__main__':
    main()
