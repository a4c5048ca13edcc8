"""The program server_queue_goals: it executes its goals one after the other."""

from __future__ import annotations

from collections import deque
from threading import Lock

from example_interfaces.action import Fibonacci
from rclpy.action.server import ServerGoalHandle

from examples_rclpy_minimal_action_server._fibonacci import MinimalActionServer, serve


class QueueingActionServer(MinimalActionServer):
    """Stores accepted goals in a queue while it executes one."""

    def __init__(self) -> None:
        super().__init__(handle_accepted_callback=self.handle_accepted_callback)
        self._goal_queue: deque[ServerGoalHandle] = deque()
        self._goal_queue_lock = Lock()
        self._current_goal: ServerGoalHandle | None = None

    def handle_accepted_callback(self, goal_handle: ServerGoalHandle) -> None:
        """Start the goal, or add it to the queue."""
        with self._goal_queue_lock:
            if self._current_goal is not None:
                self._goal_queue.append(goal_handle)
                self.get_logger().info('Goal put in the queue')
            else:
                self._current_goal = goal_handle
                self._current_goal.execute()

    def execute_callback(self, goal_handle: ServerGoalHandle) -> Fibonacci.Result:
        """Execute a goal, and then start the next one."""
        try:
            return super().execute_callback(goal_handle)
        finally:
            with self._goal_queue_lock:
                self._current_goal = self._goal_queue.popleft() if self._goal_queue else None
                if self._current_goal is not None:
                    self.get_logger().info('Start executing next goal in queue')
                    self._current_goal.execute()


def main(args: list[str] | None = None) -> None:
    """Run the program."""
    serve(QueueingActionServer, args)


if __name__ == '__main__':
    main()
