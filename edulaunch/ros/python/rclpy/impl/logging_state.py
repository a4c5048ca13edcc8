"""Levels and outputs of a program's logging, and the format of messages on the console."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, NamedTuple

from rclpy.process_state import process_state

if TYPE_CHECKING:
    from edulaunch.engine.graph.ros_arguments import RosArguments

SEVERITY_NAMES = {0: 'UNSET', 10: 'DEBUG', 20: 'INFO', 30: 'WARN', 40: 'ERROR', 50: 'FATAL'}
DEFAULT_FORMAT = '[{severity}] [{time}] [{name}]: {message}'
_COLORS = {10: '\033[32m', 20: '\033[0m', 30: '\033[33m', 40: '\033[31m', 50: '\033[31m'}
_NORMAL = '\033[0m'


class Record(NamedTuple):
    """One log message. `stamp_ns` is simulated time."""

    severity: int
    name: str
    message: str
    stamp_ns: int
    function: str
    file: str
    line: int


def _seconds(record: Record) -> str:
    seconds, nanoseconds = divmod(record.stamp_ns, 1_000_000_000)
    return f'{seconds:010}.{nanoseconds:09}'


def _date_time(record: Record) -> str:
    from datetime import datetime, timezone

    moment = datetime.fromtimestamp(record.stamp_ns // 1_000_000_000, timezone.utc)
    return f'{moment:%Y-%m-%d %H:%M:%S}.{record.stamp_ns // 1_000_000 % 1000:03}'


_TOKENS = {
    'severity': lambda record: SEVERITY_NAMES[record.severity],
    'name': lambda record: record.name,
    'message': lambda record: record.message,
    'function_name': lambda record: record.function,
    'file_name': lambda record: record.file,
    'line_number': lambda record: str(record.line),
    'time': _seconds,
    'time_as_nanoseconds': lambda record: str(record.stamp_ns),
    'date_time_with_ms': _date_time,
}


class ConsoleFormat:
    """The format of a message on the console, which the RCUTILS_* environment variables set. Colours are off by default."""

    def __init__(self, environment: Mapping[str, str]) -> None:
        self.text = environment.get('RCUTILS_CONSOLE_OUTPUT_FORMAT') or DEFAULT_FORMAT
        self.colored = environment.get('RCUTILS_COLORIZED_OUTPUT') == '1'
        self.stream = 'stdout' if environment.get('RCUTILS_LOGGING_USE_STDOUT') == '1' else 'stderr'

    def line(self, record: Record) -> str:
        """Return the formatted message with its line break."""
        if self.text == DEFAULT_FORMAT:
            text = f'[{SEVERITY_NAMES[record.severity]}] [{_seconds(record)}] [{record.name}]: {record.message}'
        else:
            text = self._expanded(record)
        color = _COLORS.get(record.severity) if self.colored else None
        return f'{text}\n' if color is None else f'{color}{text}{_NORMAL}\n'

    def _expanded(self, record: Record) -> str:
        """Return the format string with its known tokens replaced. Other text does not change."""
        head, *parts = self.text.split('{')
        for part in parts:
            token, brace, rest = part.partition('}')
            known = _TOKENS.get(token) if brace else None
            head += '{' + part if known is None else known(record) + rest
        return head


DEFAULT_LEVEL = 20


class LoggingState:
    """The state of the C layer's logging for a whole program.

    :ivar levels: the levels that were set, by logger name. A child logger inherits the level of its parent in the dotted name.
    :ivar rosout: the publisher on /rosout for the messages of each logger, by logger name.
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
        """Apply `--log-level` and the other logging options of a command line."""
        for name, level in arguments.log_levels.items():
            self.set_level(name, level)
        self.console = arguments.outputs.get('stdout', True)
        self.rosout_enabled = arguments.outputs.get('rosout', True)

    def set_level(self, name: str, level: int) -> None:
        """Set the level of a logger, or the default level for the empty name. Level 0 removes the setting."""
        if name == '':
            self.default_level = level or DEFAULT_LEVEL
        elif level:
            self.levels[name] = level
        else:
            self.levels.pop(name, None)
        self._effective.clear()

    def effective_level(self, name: str) -> int:
        """Return the level that applies to a logger."""
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
        """Write a message to the console, the recording and /rosout."""
        process = self.process
        message = process.streams.steady(message)
        now: int = process.sim.now_ns
        if self.console:
            process.write(self._format.stream, self._format.line(Record(severity, name, message, now, function, file, line)))
        process.log(severity, name, message)
        publisher = self.rosout.get(name)
        if publisher is not None and self.rosout_enabled and not publisher.destroyed:
            seconds, nanoseconds = divmod(now, 1_000_000_000)
            publisher.publish((seconds, nanoseconds, severity, name, message, file, function, line))


def logging_state() -> LoggingState:
    """Return the logging state of the running program."""
    state = process_state()
    if state.logging is None:
        state.logging = LoggingState(state.process)
    return state.logging
