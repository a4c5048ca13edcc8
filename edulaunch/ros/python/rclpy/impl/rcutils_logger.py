"""Loggers, and the keyword arguments of log calls that limit how often a message is written (`once`, `throttle_duration_sec`,
`skip_first`).
"""

from __future__ import annotations

import sys
from types import FrameType
from typing import Any

from edulaunch.engine.facts import kind_of, with_facts
from rclpy.clock import Clock
from rclpy.impl.logging_severity import LoggingSeverity
from rclpy.impl.logging_state import logging_state

_FILTERS: dict[str, dict[str, Any]] = {
    'throttle': {'throttle_duration_sec': None, 'throttle_time_source_type': False},
    'skip_first': {'skip_first': None},
    'once': {'once': None},
}
_OPTIONS = ['throttle_duration_sec', 'throttle_time_source_type', 'skip_first', 'once']


def filters_of(options: dict[str, Any]) -> tuple[str, ...]:
    """Return the filters that the keyword arguments of a log call select.

    :raises TypeError: for an unknown keyword, or for throttling without a duration.
    :raises ValueError: for a time source that is not a clock.
    """
    wanted = tuple(name for name, parameters in _FILTERS.items() if any(options.get(parameter) for parameter in parameters))
    if 'throttle' in wanted and 'throttle_duration_sec' not in options:
        raise TypeError(
            'required parameter "throttle_duration_sec" not specified but is required for the the logging filter "throttle"'
        )
    for name in options:
        if name not in _OPTIONS:
            raise TypeError(f'parameter "{name}" is not one of the recognized logging options "{_OPTIONS}"')
    source = options.get('throttle_time_source_type')
    if 'throttle' in wanted and source is not None and not isinstance(source, Clock):
        raise ValueError(f'Received throttle_time_source_type of "{source}" is not a clock instance')
    return wanted


class CallSite:
    """One log call in a program: its filters and their state."""

    __slots__ = ('name', 'severity', 'filters', 'settings', 'skipped', 'logged', 'last_ns')

    def __init__(self, name: str, severity: int, filters: tuple[str, ...], options: dict[str, Any]) -> None:
        self.name = name
        self.severity = severity
        self.filters = filters
        self.settings = _settings(filters, options)
        self.skipped = self.logged = False
        self.last_ns = 0

    def check(self, name: str, severity: int, filters: tuple[str, ...], options: dict[str, Any]) -> None:
        """Raise ValueError if the severity or the filters of a call differ from those of the first call at this place."""
        if severity != self.severity:
            raise ValueError('Logger severity cannot be changed between calls.')
        if name != self.name:
            raise ValueError('Logger name cannot be changed between calls.')
        if filters != self.filters:
            raise ValueError('Requested logging filters cannot be changed between calls.')
        if filters and _settings(filters, options) != self.settings:
            raise ValueError('Logging filter parameters cannot be changed between calls.')

    def lets_through(self, options: dict[str, Any], now_ns: int) -> bool:
        """Return whether to write the message of this call. Filters are applied in order, until one rejects the message."""
        return all(self._passes(name, options, now_ns) for name in self.filters)

    def _passes(self, name: str, options: dict[str, Any], now_ns: int) -> bool:
        if name == 'once':
            before, self.logged = self.logged, True
            return not before
        if name == 'skip_first':
            before, self.skipped = self.skipped, True
            return before
        source = options.get('throttle_time_source_type')
        if isinstance(source, Clock):
            now_ns = source.rcl_now_ns()
        if now_ns < self.last_ns + options['throttle_duration_sec'] * 1e9:
            return False
        self.last_ns = now_ns
        return True


def _settings(filters: tuple[str, ...], options: dict[str, Any]) -> list[Any]:
    """Return the arguments of a call's filters. They must be the same in every call at one place."""
    return [options.get(parameter) for name in filters for parameter in _FILTERS[name]]


DEBUG, INFO, WARN, ERROR, FATAL = 10, 20, 30, 40, 50


class RcutilsLogger:
    """A logger, which `node.get_logger()` or `rclpy.logging.get_logger(name)` returns.

    Each log method takes one string, and returns whether the message was written. The filters are `once=True`, `skip_first=True`
    and `throttle_duration_sec=...` (with `throttle_time_source_type=<a Clock>`); `name=...` sets the name of another logger. Each
    filter stores its state for the place of the call.

    :raises TypeError: for an unknown keyword, or a message that is not a string, bytes or None.
    :raises ValueError: when the severity or the filters change at one place.
    """

    def __init__(self, name: str = '') -> None:
        self.name = name
        self.contexts: dict[tuple[str, str, int, int], CallSite] = {}

    def get_child(self, name: str) -> RcutilsLogger:
        """Return the logger `<this name>.<name>`. The child publishes on /rosout if this logger publishes there."""
        if not name:
            raise ValueError('Child logger name must not be empty.')
        if not self.name:
            return RcutilsLogger(name)
        child = RcutilsLogger(self.name + '.' + name)
        rosout = logging_state().rosout
        if self.name in rosout:
            rosout.setdefault(child.name, rosout[self.name])
        return child

    def set_level(self, level: LoggingSeverity | int) -> None:
        """Set the lowest severity that is written."""
        logging_state().set_level(self.name, LoggingSeverity(level))

    def get_effective_level(self) -> LoggingSeverity:
        """Return the level that applies: the level of this logger or of a parent, or else the default level."""
        return LoggingSeverity(logging_state().effective_level(self.name))

    def is_enabled_for(self, severity: LoggingSeverity | int) -> bool:
        """Return whether messages of this severity are written."""
        return int(severity) >= logging_state().effective_level(self.name)

    def debug(self, message: str, **kwargs: Any) -> bool:
        """Log with severity DEBUG."""
        return self._log(message, DEBUG, sys._getframe(1), kwargs)

    def info(self, message: str, **kwargs: Any) -> bool:
        """Log with severity INFO."""
        return self._log(message, INFO, sys._getframe(1), kwargs)

    def warning(self, message: str, **kwargs: Any) -> bool:
        """Log with severity WARN."""
        return self._log(message, WARN, sys._getframe(1), kwargs)

    def warn(self, message: str, **kwargs: Any) -> bool:
        """Log with severity WARN."""
        return self._log(message, WARN, sys._getframe(1), kwargs)

    def error(self, message: str, **kwargs: Any) -> bool:
        """Log with severity ERROR."""
        return self._log(message, ERROR, sys._getframe(1), kwargs)

    def fatal(self, message: str, **kwargs: Any) -> bool:
        """Log with severity FATAL."""
        return self._log(message, FATAL, sys._getframe(1), kwargs)

    def log(self, message: str, severity: LoggingSeverity | int, **kwargs: Any) -> bool:
        """Log with the given severity."""
        return self._log(message, int(LoggingSeverity(severity)), sys._getframe(1), kwargs)

    def _log(self, message: Any, severity: int, frame: FrameType, options: dict[str, Any]) -> bool:
        name = _checked_name(options.pop('name')) if 'name' in options else self.name
        state = logging_state()
        if severity < state.effective_level(name):
            return False
        code = frame.f_code
        place = (code.co_filename, code.co_name, code.co_firstlineno, frame.f_lasti)
        filters = filters_of(options) if options else ()
        site = self.contexts.get(place)
        if site is None:
            site = self.contexts[place] = CallSite(name, severity, filters, options)
        else:
            site.check(name, severity, filters, options)
        sim = state.process.sim
        if sim.keep_up is not None:
            sim.keep_up()
        if filters and not site.lets_through(options, sim.now_ns):
            return False
        if not isinstance(message, str):
            message = _text_of(message)
        state.output(severity, name, message, code.co_name, code.co_filename, frame.f_lineno)
        return True


def _checked_name(name: Any) -> str:
    """Return the logger name that a log call gives, or the root logger's name for None."""
    if name is not None and not isinstance(name, str):
        raise TypeError(
            'rclpy_logging_rcutils_log(): incompatible function arguments: the name of a logger must be a str, '
            f'not {type(name).__name__}'
        )
    return name or ''


def _text_of(message: Any) -> str:
    """Convert a message that is not a string, as C does. Accept None and bytes, and reject other types."""
    if message is None:
        return '(null)'
    if isinstance(message, bytes):
        return message.decode(errors='replace')
    raise with_facts(
        TypeError(
            'rclpy_logging_rcutils_log(): incompatible function arguments: a log message must be a str, '
            f'not {type(message).__name__}'
        ),
        'programs.log-no-text',
        given=kind_of(message),
    )
