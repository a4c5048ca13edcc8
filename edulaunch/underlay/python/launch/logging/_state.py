"""The loggers of one process."""

from __future__ import annotations

import logging
from typing import Any

from .._engine import process_state, running_process
from ._config import LaunchConfig


class LaunchLogger(logging.Logger):
    """A logger that keeps its records to itself and stamps them with simulated time."""

    def __init__(self, name: str, level: int = logging.NOTSET) -> None:
        super().__init__(name, level)
        self.propagate = False
        self._is_output = name.endswith(('-stdout', '-stderr'))

    def findCaller(self, stack_info: bool = False, stacklevel: int = 1) -> tuple[str, int, str, str | None]:
        """No format of launch shows the caller; looking for it would cost more than the rest."""
        return '(unknown file)', 0, '(unknown function)', None

    def makeRecord(self, *args: Any, **kwargs: Any) -> logging.LogRecord:
        """A record with the simulated time."""
        record = super().makeRecord(*args, **kwargs)
        now_ns = running_process().sim.now_ns
        record.created = now_ns / 1e9
        record.msecs = now_ns // 1_000_000 % 1000
        return record

    def handle(self, record: logging.LogRecord) -> None:
        """Write the record, and (unless it is a line that a program printed) let the simulation record it
        too.
        """
        if not self._is_output:
            running_process().log(record.levelno, record.name, record.getMessage())
        super().handle(record)


class LoggingState:
    """What upstream keeps in globals: `root`, the loggers below it, and the `config`."""

    def __init__(self) -> None:
        self.config: LaunchConfig
        self.reset()

    def reset(self) -> None:
        """Start again from nothing."""
        self.root = LaunchLogger('root', logging.INFO)
        self._manager = logging.Manager(self.root)  # type: ignore[arg-type]
        self._manager.setLoggerClass(LaunchLogger)
        self.root.manager = self._manager
        self.config = LaunchConfig(self.root)

    def get_logger(self, name: str | None = None) -> logging.Logger:
        """The logger of that name, without adding handlers."""
        if not name:
            return self.root
        known = self._manager.loggerDict.get(name)
        if isinstance(known, LaunchLogger):
            return known
        if '.' in name:
            return self._manager.getLogger(name)
        logger = self._manager.loggerDict[name] = LaunchLogger(name)  # without the locks and searches of the manager
        logger.parent = self.root
        logger.manager = self._manager
        return logger


def logging_state() -> LoggingState:
    """The loggers of the running process."""
    return process_state('launch.loggers', LoggingState)
