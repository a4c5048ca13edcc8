"""How a log message looks on the console: RCUTILS_CONSOLE_OUTPUT_FORMAT and colours."""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

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
    """The console line of a message, by the RCUTILS_* variables of an environment. Colours are off unless these ask for them."""

    def __init__(self, environment: Mapping[str, str]) -> None:
        self.text = environment.get('RCUTILS_CONSOLE_OUTPUT_FORMAT') or DEFAULT_FORMAT
        self.colored = environment.get('RCUTILS_COLORIZED_OUTPUT') == '1'
        self.stream = 'stdout' if environment.get('RCUTILS_LOGGING_USE_STDOUT') == '1' else 'stderr'

    def line(self, record: Record) -> str:
        """The line, with its end."""
        if self.text == DEFAULT_FORMAT:
            text = f'[{SEVERITY_NAMES[record.severity]}] [{_seconds(record)}] [{record.name}]: {record.message}'
        else:
            text = self._expanded(record)
        color = _COLORS.get(record.severity) if self.colored else None
        return f'{text}\n' if color is None else f'{color}{text}{_NORMAL}\n'

    def _expanded(self, record: Record) -> str:
        """Known tokens in braces replaced; anything else stays as it is."""
        head, *parts = self.text.split('{')
        for part in parts:
            token, brace, rest = part.partition('}')
            known = _TOKENS.get(token) if brace else None
            head += '{' + part if known is None else known(record) + rest
        return head
