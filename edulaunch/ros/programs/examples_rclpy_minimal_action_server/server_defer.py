"""The program server_defer: it starts each goal three seconds after accepting it."""

from __future__ import annotations

from rclpy.action.server import ServerGoalHandle
from rclpy.timer import Timer

from examples_rclpy_minimal_action_server._fibonacci import MinimalActionServer, serve

DELAY_S = 3.0


class DeferringActionServer(MinimalActionServer):
    """Delays the goal that was accepted last."""

    def __init__(self) -> None:
        super().__init__(handle_accepted_callback=self.handle_accepted_callback)
        self._goal_handle: ServerGoalHandle | None = None
        self._timer: Timer | None = None

    def handle_accepted_callback(self, goal_handle: ServerGoalHandle) -> None:
        """Delay the goal."""
        self._goal_handle = goal_handle
        self.get_logger().info('Deferring execution...')
        self._timer = self.create_timer(DELAY_S, self.timer_callback)

    def timer_callback(self) -> None:
        """Start the goal once."""
        if self._goal_handle is not None:
            self._goal_handle.execute()
        if self._timer is not None:
            self._timer.cancel()


def main(args: list[str] | None = None) -> None:
    """Run the program."""
    serve(DeferringActionServer, args)


if __name__ == '__main__':
    main()
