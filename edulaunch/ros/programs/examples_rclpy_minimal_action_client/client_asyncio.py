"""The program client_asyncio: two goals at once, in an asyncio event loop that also spins the node."""

from __future__ import annotations

import asyncio

import rclpy
from example_interfaces.action import Fibonacci
from rclpy.action import ActionClient
from rclpy.logging import get_logger
from rclpy.node import Node

from edulaunch.ros.running import run

ORDER = 10


class MinimalActionClientAsyncIO(Node):
    """An action client whose goals are coroutines."""

    def __init__(self) -> None:
        super().__init__('minimal_action_client_asyncio')
        self._action_client = ActionClient(self, Fibonacci, 'fibonacci')

    async def send_goal(self) -> tuple[Fibonacci.Result, int] | None:
        """Return the result and the status of a goal, or None if the goal was rejected."""
        self.get_logger().info('Waiting for action server...')
        self._action_client.wait_for_server()
        self.get_logger().info('Sending goal request...')
        goal_handle = await self._action_client.send_goal_async(
            Fibonacci.Goal(order=ORDER), feedback_callback=self.feedback_callback
        )
        if not goal_handle.accepted:
            self.get_logger().info('Goal rejected :(')
            return None
        self.get_logger().info('Goal accepted :)')
        reply = await goal_handle.get_result_async()
        self.get_logger().info(f'Result: {reply.result.sequence}')
        return reply.result, reply.status

    def feedback_callback(self, feedback: Fibonacci.Impl.FeedbackMessage) -> None:
        """Log the progress of the goal."""
        self.get_logger().info(f'Received feedback: {feedback.feedback.sequence}')


async def spinning(node: Node) -> None:
    """Spin the node between the other tasks of the event loop."""
    while rclpy.ok():
        rclpy.spin_once(node, timeout_sec=0.01)
        await asyncio.sleep(0.001)


async def work() -> None:
    """Send two goals, while a task spins the node."""
    client = MinimalActionClientAsyncIO()
    spin_task = asyncio.get_running_loop().create_task(spinning(client))
    results = await asyncio.gather(client.send_goal(), client.send_goal())
    for found in filter(None, results):
        get_logger('minimal_action_client').info(f'result {found[0]} and status flag {found[1]}')
    spin_task.cancel()


def main(args: list[str] | None = None) -> None:
    """Run the program."""
    run(lambda: asyncio.run(work()), args)


if __name__ == '__main__':
    main()
