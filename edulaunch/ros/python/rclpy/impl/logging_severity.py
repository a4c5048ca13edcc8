"""How grave a log message is."""

from __future__ import annotations

from enum import IntEnum


class LoggingSeverity(IntEnum):
    """Severities; a logger that is UNSET takes its parent's."""

    UNSET = 0
    DEBUG = 10
    INFO = 20
    WARN = 30
    ERROR = 40
    FATAL = 50
