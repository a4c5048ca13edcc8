"""Launch's log lines on the screen and, on request, in files.

As in upstream, `launch_config` contains formats, level and destinations. `get_logger(name)` and `get_output_loggers(process,
output)` return loggers with these settings. Differences from upstream:

* Loggers, handlers and `launch_config` belong to the running process (`LoggingState`), not to the
  interpreter, so two simulations do not share them. `launch_config` represents the configuration of the running
  process.
* The screen is the process's own standard output.
* **Log files are written only on request**: when ROS_LOG_DIR or ROS_HOME is set in the process's
  environment, or `launch_config.log_dir` or `launch_config.log_handler_factory` was set. A command in a
  terminal always has ROS_HOME. Otherwise, no file is created below `~/.ros`, and the line "All log files can be found
  below ..." is not printed. Reading `launch_config.log_dir` creates the folder.
* Times in log lines are simulated.
"""

from __future__ import annotations

import logging
from typing import Any

from . import handlers
from ._output import OutputConfig, normalize_output_configuration
from ._state import LaunchConfig, LaunchLogger, _get_logging_directory, _make_unique_log_dir, _renew_latest_log_dir, logging_state

__all__ = [
    'LaunchConfig',
    'LaunchLogger',
    'get_logger',
    'get_output_loggers',
    'handlers',
    'launch_config',
    'log_launch_config',
    'reset',
    '_get_logging_directory',
    '_make_unique_log_dir',
    '_renew_latest_log_dir',
]

_LINE = logging.Formatter('{msg}', style='{')
_TIME_AND_LINE = logging.Formatter('{created:.7f} {msg}', style='{')


class _CurrentLaunchConfig:
    """Represents the `LaunchConfig` of the running process."""

    def __getattr__(self, name: str) -> Any:
        return getattr(logging_state().config, name)

    def __setattr__(self, name: str, value: Any) -> None:
        setattr(logging_state().config, name, value)

    def __dir__(self) -> list[str]:
        return dir(logging_state().config)


launch_config: Any = _CurrentLaunchConfig()
"""The configuration (a :class:`LaunchConfig`) of the running process."""


def __getattr__(name: str) -> Any:
    if name == 'root':
        return logging_state().root
    raise AttributeError(f'module {__name__!r} has no attribute {name!r}')


def get_logger(name: str | None = None) -> logging.Logger:
    """Return the logger with this name, or the root logger without a name. The logger writes to the screen and, if log files
    are written, to launch.log.
    """
    state = logging_state()
    logger = state.get_logger(name)
    for handler in (state.config.get_screen_handler(), state.config.get_log_file_handler()):
        if handler not in logger.handlers:
            logger.addHandler(handler)
    return logger


def get_output_loggers(
    process_name: str, output_config: OutputConfig, main_log_file_name: str = 'launch.log'
) -> tuple[logging.Logger, logging.Logger]:
    """Return the loggers `<process>-stdout` and `<process>-stderr` for the output of a program.

    :param output_config: 'screen', 'log', 'both', 'own_log', 'full', or a dictionary from 'stdout', 'stderr'
        and 'both' to one or more of 'screen', 'log' and 'own_log'.
    :raises ValueError: for any other configuration.
    """
    places = normalize_output_configuration(output_config)
    state = logging_state()
    for source in ('stdout', 'stderr'):
        logger = state.get_logger(f'{process_name}-{source}')
        wanted = places['both'] | places[source]
        if 'screen' in wanted:
            _add(logger, state.config.get_screen_handler(), _LINE)
        if 'log' in wanted:
            _add(logger, state.config.get_log_file_handler(main_log_file_name), _TIME_AND_LINE)
        if 'own_log' in places[source]:
            _add(logger, state.config.get_log_file_handler(f'{process_name}-{source}.log'), _LINE)
        if 'own_log' in places['both']:
            _add(logger, state.config.get_log_file_handler(f'{process_name}.log'), _LINE)
    return state.get_logger(f'{process_name}-stdout'), state.get_logger(f'{process_name}-stderr')


def _add(logger: logging.Logger, handler: Any, formatter: logging.Formatter) -> None:
    if handler not in logger.handlers:
        handler.setFormatterFor(logger, formatter)
        logger.addHandler(handler)


def log_launch_config(*, logger: logging.Logger | None = None) -> None:
    """Log the folder of the log files, if they exist, and the log level."""
    logger = logging_state().root if logger is None else logger
    config = logging_state().config
    if config.file_handlers:
        logger.info(f'All log files can be found below {config.log_dir}')
    logger.info(f'Default logging verbosity is set to {logging.getLevelName(config.level)}')


def reset() -> None:
    """Delete all loggers, handlers and settings of the running process."""
    logging_state().reset()
