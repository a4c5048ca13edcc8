"""The program client_cancel: it cancels its goal after two seconds."""

from __future__ import annotations

import rclpy
from rclpy.action.client import ClientGoalHandle
from rclpy.task import Future

from examples_rclpy_minimal_action_client.client import MinimalActionClient, send

PATIENCE_S = 2.0


class CancellingActionClient(MinimalActionClient):
    """Cancels its goal after two seconds."""

    def accepted(self, goal_handle: ClientGoalHandle) -> None:
        """Start the timer that cancels the goal."""
        self._goal_handle = goal_handle
        self._timer = self.create_timer(PATIENCE_S, self.timer_callback)

    def timer_callback(self) -> None:
        """Cancel the goal once."""
        self.get_logger().info('Canceling goal')
        self._goal_handle.cancel_goal_async().add_done_callback(self.cancel_done)
        self._timer.cancel()

    def cancel_done(self, future: Future) -> None:
        """Log the reply and end."""
        went_well = len(future.result().goals_canceling) > 0
        self.get_logger().info('Goal successfully canceled' if went_well else 'Goal failed to cancel')
        rclpy.shutdown()


def main(args: list[str] | None = None) -> None:
    """Run the program."""
    send(CancellingActionClient, args)


if __name__ == '__main__':
    main()
