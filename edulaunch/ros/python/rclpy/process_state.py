"""The state of rclpy that ROS 2 stores in global variables. Here, it belongs to the running process, which keeps simulations and
programs separate.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from edulaunch.engine.processes.current import current_process

if TYPE_CHECKING:
    from rclpy.impl.logging_state import LoggingState
    from rclpy.impl.protocols import ContextProtocol


class ProcessState:
    """The state of rclpy in one running program.

    :ivar contexts: all initialised contexts, in order of initialisation; signals shut them down.
    :ivar previous_handlers: pairs (rclpy's handler, the previous handler) by signal number, while rclpy handles signals.
    :ivar goal_ids: the random generator of action goal IDs.
    :ivar interrupted_at: the student's line at which the last signal interrupted the main thread, as in `student_line`.
    """

    def __init__(self, process: Any) -> None:
        self.process = process
        self.default_context: Any = None  # a Context, or None
        self.global_executor: Any = None  # an Executor, or None
        self.contexts: list[ContextProtocol] = []
        self.signal_options: Any = None
        self.previous_handlers: dict[int, Any] = {}
        self.logging: LoggingState | None = None
        self.goal_ids: Any = None
        self.interrupted_at: dict[str, Any] = {}


def process_state() -> ProcessState:
    """Return the state of the running program. Create it on first use."""
    process = current_process()
    state: ProcessState | None = process.state.get('rclpy')
    if state is None:
        state = process.state['rclpy'] = ProcessState(process)
    return state
