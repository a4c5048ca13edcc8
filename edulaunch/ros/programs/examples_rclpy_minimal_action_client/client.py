"""The program client: it sends a goal, logs its feedback and its result, and ends."""

from __future__ import annotations

import rclpy
from action_msgs.msg import GoalStatus
from example_interfaces.action import Fibonacci
from rclpy.action import ActionClient
from rclpy.action.client import ClientGoalHandle
from rclpy.node import Node
from rclpy.task import Future

from edulaunch.ros.running import run

ORDER = 10


class MinimalActionClient(Node):
    """Sends a goal and handles each reply in a callback."""

    def __init__(self) -> None:
        super().__init__('minimal_action_client')
        self._action_client = ActionClient(self, Fibonacci, 'fibonacci')

    def send_goal(self) -> None:
        """Wait for the server, and send the goal."""
        self.get_logger().info('Waiting for action server...')
        self._action_client.wait_for_server()
        self.get_logger().info('Sending goal request...')
        sent = self._action_client.send_goal_async(Fibonacci.Goal(order=ORDER), feedback_callback=self.feedback_callback)
        sent.add_done_callback(self.goal_response_callback)

    def goal_response_callback(self, future: Future) -> None:
        """Request the result of an accepted goal."""
        goal_handle: ClientGoalHandle = future.result()
        if not goal_handle.accepted:
            self.get_logger().info('Goal rejected :(')
            return
        self.get_logger().info('Goal accepted :)')
        self.accepted(goal_handle)

    def accepted(self, goal_handle: ClientGoalHandle) -> None:
        """Wait for the result of an accepted goal."""
        goal_handle.get_result_async().add_done_callback(self.get_result_callback)

    def feedback_callback(self, feedback: Fibonacci.Impl.FeedbackMessage) -> None:
        """Log the progress of the goal."""
        self.get_logger().info(f'Received feedback: {feedback.feedback.sequence}')

    def get_result_callback(self, future: Future) -> None:
        """Log the result and end."""
        status = future.result().status
        if status == GoalStatus.STATUS_SUCCEEDED:
            self.get_logger().info(f'Goal succeeded! Result: {future.result().result.sequence}')
        else:
            self.get_logger().info(f'Goal failed with status: {status}')
        rclpy.shutdown()


def send(make_client: type[MinimalActionClient], args: list[str] | None) -> None:
    """Run a client until it shuts ROS 2 down."""

    def body() -> None:
        client = make_client()
        client.send_goal()
        rclpy.spin(client)

    run(body, args)


def main(args: list[str] | None = None) -> None:
    """Run the program."""
    send(MinimalActionClient, args)


if __name__ == '__main__':
    main()
