"""What would be global variables of rclpy: kept with the running process, so that simulations and programs never meet."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any

from edulaunch.processes.current import current_process

if TYPE_CHECKING:
    from rclpy.context import Context
    from rclpy.executors import Executor
    from rclpy.impl.logging_state import LoggingState


class ProcessState:
    """rclpy's side of one running program.

    :ivar contexts: all initialised contexts, in order; signals shut them down.
    :ivar loggers: per logger name, what its call sites remember (`once`, `throttle_duration_sec` ...).
    """

    def __init__(self, process: Any) -> None:
        self.process = process
        self.default_context: Context | None = None
        self.global_executor: Executor | None = None
        self.contexts: list[Context] = []
        self.signal_options: Any = None
        self.logging: LoggingState | None = None
        self.lifecycle_names: dict[str, Any] = {}


def process_state() -> ProcessState:
    """The state of the program that runs now; made at first use."""
    process = current_process()
    state: ProcessState | None = process.state.get('rclpy')
    if state is None:
        state = process.state['rclpy'] = ProcessState(process)
    return state
