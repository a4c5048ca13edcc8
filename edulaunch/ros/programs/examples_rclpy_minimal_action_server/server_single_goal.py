"""The program server_single_goal: a new goal aborts the previous goal."""

from __future__ import annotations

from threading import Lock

from rclpy.action.server import ServerGoalHandle

from examples_rclpy_minimal_action_server._fibonacci import MinimalActionServer, serve


class SingleGoalActionServer(MinimalActionServer):
    """Executes only the newest goal."""

    def __init__(self) -> None:
        super().__init__(handle_accepted_callback=self.handle_accepted_callback)
        self._goal_handle: ServerGoalHandle | None = None
        self._goal_lock = Lock()

    def handle_accepted_callback(self, goal_handle: ServerGoalHandle) -> None:
        """Abort the current goal, and start the new goal."""
        with self._goal_lock:
            if self._goal_handle is not None and self._goal_handle.is_active:
                self.get_logger().info('Aborting previous goal')
                self._goal_handle.abort()
            self._goal_handle = goal_handle
        goal_handle.execute()


def main(args: list[str] | None = None) -> None:
    """Run the program."""
    serve(SingleGoalActionServer, args)


if __name__ == '__main__':
    main()
