"""Python's log handlers, with a format for each logger.

The handlers are `Handler`, `StreamHandler`, `FileHandler`, `NullHandler` and all handlers of `logging.handlers`.
"""

from __future__ import annotations

import logging
from importlib import import_module
from typing import Any


def with_per_logger_formatting(cls: type[logging.Handler]) -> type[Any]:
    """Return a subclass of a handler class with the methods `setFormatterFor(logger, formatter)` and
    `unsetFormatterFor(logger)`.
    """

    class Trait(cls):  # type: ignore[misc,valid-type]
        """A handler that can use a separate format for some loggers."""

        def __init__(self, *args: Any, **kwargs: Any) -> None:
            super().__init__(*args, **kwargs)
            self._formatters: dict[str, logging.Formatter] = {}

        def setFormatterFor(self, logger: logging.Logger, formatter: logging.Formatter) -> None:
            """Format records of this logger with `formatter`."""
            self._formatters[logger.name] = formatter

        def unsetFormatterFor(self, logger: logging.Logger) -> None:
            """Remove the separate format of this logger."""
            self._formatters.pop(logger.name, None)

        def format(self, record: logging.LogRecord) -> str:
            """Return the formatted line of a record."""
            formatter = self._formatters.get(record.name)
            return super().format(record) if formatter is None else formatter.format(record)

    Trait.__name__ = Trait.__qualname__ = cls.__name__
    return Trait


Handler = with_per_logger_formatting(logging.Handler)
StreamHandler = with_per_logger_formatting(logging.StreamHandler)
FileHandler = with_per_logger_formatting(logging.FileHandler)
NullHandler = with_per_logger_formatting(logging.NullHandler)


def __getattr__(name: str) -> Any:
    wrapped = getattr(import_module('logging.handlers'), name, None)
    if not (isinstance(wrapped, type) and issubclass(wrapped, logging.Handler)):
        raise AttributeError(f'module {__name__!r} has no attribute {name!r}')
    handler = globals()[name] = with_per_logger_formatting(wrapped)
    return handler
