"""Levels and outputs of a program's logging."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from rclpy.impl.log_format import ConsoleFormat, Record
from rclpy.process_state import process_state

if TYPE_CHECKING:
    from edulaunch.graph.ros_arguments import RosArguments

DEFAULT_LEVEL = 20


class LoggingState:
    """What the C layer keeps for a whole program.

    :ivar levels: logger name -> level, where one was set; children inherit by dotted prefix.
    :ivar rosout: logger name -> the publisher of /rosout that its messages go out on.
    """

    def __init__(self, process: Any) -> None:
        self.process = process
        self.default_level = DEFAULT_LEVEL
        self.levels: dict[str, int] = {}
        self.rosout: dict[str, Any] = {}
        self.console = True
        self.rosout_enabled = True
        self._format = ConsoleFormat(process.env)
        self._effective: dict[str, int] = {}

    def configure(self, arguments: RosArguments) -> None:
        """Take over `--log-level` and the switches of a command line."""
        for name, level in arguments.log_levels.items():
            self.set_level(name, level)
        self.console = arguments.outputs.get('stdout', True)
        self.rosout_enabled = arguments.outputs.get('rosout', True)

    def set_level(self, name: str, level: int) -> None:
        """Set the level of a logger, '' for the default; 0 takes it back."""
        if name == '':
            self.default_level = level or DEFAULT_LEVEL
        elif level:
            self.levels[name] = level
        else:
            self.levels.pop(name, None)
        self._effective.clear()

    def effective_level(self, name: str) -> int:
        """The level that counts for a logger."""
        level = self._effective.get(name)
        if level is None:
            level = self._effective[name] = self._inherited(name)
        return level

    def _inherited(self, name: str) -> int:
        while name:
            if name in self.levels:
                return self.levels[name]
            name = name.rpartition('.')[0]
        return self.default_level

    def output(self, severity: int, name: str, message: str, function: str = '', file: str = '', line: int = 0) -> None:
        """Write a message to the console, the record and /rosout."""
        process = self.process
        message = process.steady(message)
        now: int = process.sim.now_ns
        if self.console:
            process.write(self._format.stream, self._format.line(Record(severity, name, message, now, function, file, line)))
        process.log(severity, name, message)
        publisher = self.rosout.get(name)
        if publisher is not None and self.rosout_enabled and not publisher.destroyed:
            seconds, nanoseconds = divmod(now, 1_000_000_000)
            publisher.publish((seconds, nanoseconds, severity, name, message, file, function, line))


def logging_state() -> LoggingState:
    """The logging of the program that runs now."""
    state = process_state()
    if state.logging is None:
        state.logging = LoggingState(state.process)
    return state.logging
