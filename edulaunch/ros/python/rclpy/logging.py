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
    """Return the logger with the given name. Raise ValueError for an empty name."""
    if not name:
        raise ValueError('Logger name must not be empty.')
    return RcutilsLogger(name)


def initialize() -> None:
    """Initialise logging. rclpy calls this function automatically."""
    logging_state()


def shutdown() -> None:
    """Do nothing, because logging has no buffer to flush."""


def clear_config() -> None:
    """Reset the levels of all loggers."""
    state = logging_state()
    for name in list(state.levels):
        state.set_level(name, 0)
    state.set_level('', 0)


def set_logger_level(name: str, level: LoggingSeverity | int, detailed_error: bool = False) -> None:
    """Set a logger's level. The empty name sets the default level."""
    logging_state().set_level(name, LoggingSeverity(level))


def get_logger_effective_level(name: str) -> LoggingSeverity:
    """Return the level that applies to a logger."""
    return LoggingSeverity(logging_state().effective_level(name))


def get_logger_level(name: str) -> LoggingSeverity:
    """Return the level that was set for a logger itself, or UNSET if none was set."""
    state = logging_state()
    return LoggingSeverity(state.default_level if name == '' else state.levels.get(name, 0))


def get_logging_severity_from_string(log_severity: str) -> LoggingSeverity:
    """Return the severity with the given name, such as 'WARN', in upper or lower case. Raise RuntimeError for an unknown name."""
    try:
        return LoggingSeverity[log_severity.upper()]
    except KeyError:
        raise with_facts(RuntimeError('Failed to get severity name'), 'programs.severity-name') from None


def get_logging_directory() -> Path:
    """Return the folder for log files."""
    env: dict[str, str] = logging_state().process.env
    from pathlib import Path

    return Path(env.get('ROS_LOG_DIR') or (env.get('ROS_HOME') or env.get('HOME', '~') + '/.ros') + '/log')
