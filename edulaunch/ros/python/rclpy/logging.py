"""Loggers and their levels."""

from __future__ import annotations

from typing import TYPE_CHECKING

from edulaunch.engine.facts import with_facts
from rclpy.impl.logging_severity import LoggingSeverity as LoggingSeverity
from rclpy.impl.logging_state import logging_state
from rclpy.impl.rcutils_logger import RcutilsLogger

if TYPE_CHECKING:
    from pathlib import Path


_root_logger = RcutilsLogger()  # programs use this as the root logger, because there is no public name


def get_logger(name: str) -> RcutilsLogger:
    """Return the logger of that name. Raises ValueError for an empty name."""
    if not name:
        raise ValueError('Logger name must not be empty.')
    return RcutilsLogger(name)


def initialize() -> None:
    """Set logging up; happens by itself."""
    logging_state()


def shutdown() -> None:
    """End logging; nothing is held back."""


def clear_config() -> None:
    """Reset the levels of all loggers."""
    state = logging_state()
    for name in list(state.levels):
        state.set_level(name, 0)
    state.set_level('', 0)


def set_logger_level(name: str, level: LoggingSeverity | int, detailed_error: bool = False) -> None:
    """Set a logger's level; the empty name is the default of all."""
    logging_state().set_level(name, LoggingSeverity(level))


def get_logger_effective_level(name: str) -> LoggingSeverity:
    """Return the level that counts for a logger."""
    return LoggingSeverity(logging_state().effective_level(name))


def get_logger_level(name: str) -> LoggingSeverity:
    """Return the level that was set for a logger itself, UNSET when none was."""
    state = logging_state()
    return LoggingSeverity(state.default_level if name == '' else state.levels.get(name, 0))


def get_logging_severity_from_string(log_severity: str) -> LoggingSeverity:
    """Return the severity of a name such as 'WARN', in any case. Raises RuntimeError for an unknown one."""
    try:
        return LoggingSeverity[log_severity.upper()]
    except KeyError:
        raise with_facts(RuntimeError('Failed to get severity name'), 'programs.severity-name') from None


def get_logging_directory() -> Path:
    """Return where log files would be written."""
    env: dict[str, str] = logging_state().process.env
    from pathlib import Path

    return Path(env.get('ROS_LOG_DIR') or (env.get('ROS_HOME') or env.get('HOME', '~') + '/.ros') + '/log')
