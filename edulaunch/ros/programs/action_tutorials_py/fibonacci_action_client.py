"""The program fibonacci_action_client: it requests ten Fibonacci numbers and ends."""

from __future__ import annotations

import rclpy
from action_tutorials_interfaces.action import Fibonacci
from rclpy.action import ActionClient
from rclpy.node import Node
from rclpy.task import Future

from edulaunch.ros.running import run

ORDER = 10


class FibonacciActionClient(Node):
    """Sends a goal and handles each reply in a callback."""

    def __init__(self) -> None:
        super().__init__('fibonacci_action_client')
        self._action_client = ActionClient(self, Fibonacci, 'fibonacci')

    def send_goal(self, order: int) -> None:
        """Wait for the server, and send the goal."""
        self._action_client.wait_for_server()
        goal = Fibonacci.Goal(order=order)
        sent = self._action_client.send_goal_async(goal, feedback_callback=self.feedback_callback)
        sent.add_done_callback(self.goal_response_callback)

    def goal_response_callback(self, future: Future) -> None:
        """Request the result of an accepted goal."""
        goal_handle = future.result()
        if not goal_handle.accepted:
            self.get_logger().info('Goal rejected :(')
            return
        self.get_logger().info('Goal accepted :)')
        goal_handle.get_result_async().add_done_callback(self.get_result_callback)

    def get_result_callback(self, future: Future) -> None:
        """Log the result and end."""
        self.get_logger().info(f'Result: {future.result().result.sequence}')
        rclpy.shutdown()

    def feedback_callback(self, feedback_msg: Fibonacci.Impl.FeedbackMessage) -> None:
        """Log the progress of the goal."""
        self.get_logger().info(f'Received feedback: {feedback_msg.feedback.partial_sequence}')


def work() -> None:
    """Send the goal, and spin until the client shuts ROS 2 down."""
    client = FibonacciActionClient()
    client.send_goal(ORDER)
    rclpy.spin(client)


def main(args: list[str] | None = None) -> None:
    """Run the program."""
    run(work, args)


if __name__ == '__main__':
    main()
