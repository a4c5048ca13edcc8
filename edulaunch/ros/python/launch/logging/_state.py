"""The loggers of one process."""

from __future__ import annotations

import logging
import os
import warnings
from collections.abc import Callable
from time import gmtime, strftime
from typing import Any

from .._engine import environment, process_state, running_process
from . import handlers


def _get_logging_directory() -> str:
    """Return the folder in which each launch creates its own folder: $ROS_LOG_DIR, else $ROS_HOME/log, else ~/.ros/log."""
    env = environment()
    log_dir = env.get('ROS_LOG_DIR')
    if not log_dir:
        log_dir = os.path.join(env.get('ROS_HOME') or os.path.join('~', '.ros'), 'log')
    return os.path.expanduser(log_dir)


def _make_unique_log_dir(*, base_path: str) -> str:
    """Create `base_path/YYYY-MM-DD-HH-MM-SS-microseconds-HOST-PID` with the simulated time. Append `-2`, `-3` and so on if the
    folder already exists.
    """
    from socket import gethostname

    process = running_process()
    seconds, ns = divmod(process.sim.now_ns, 1_000_000_000)
    date = strftime('%Y-%m-%d-%H-%M-%S', gmtime(seconds))
    name = f'{date}-{ns // 1000:06d}-{gethostname()}-{process.pid}'
    first = os.path.join(base_path, name)
    count = _free_number(first)
    while True:
        path = _numbered(first, count)
        try:
            os.makedirs(path)
            return path
        except FileExistsError:  # another program was faster
            count += 1


def _numbered(first: str, count: int) -> str:
    return first if count == 1 else f'{first}-{count}'


def _free_number(first: str) -> int:
    """Return an unused number by bisection, because many launches begin at the same simulated time."""
    if not os.path.exists(first):
        return 1
    taken, free = 1, 2
    while os.path.exists(_numbered(first, free)):
        taken, free = free, free * 2
    while free - taken > 1:
        middle = (taken + free) // 2
        if os.path.exists(_numbered(first, middle)):
            taken = middle
        else:
            free = middle
    return free


def _renew_latest_log_dir(*, log_dir: str) -> bool:
    """Set the link `latest` in the parent folder of `log_dir` to `log_dir`. Return False if that name belongs to a file that
    is not a link.
    """
    link = os.path.join(os.path.dirname(log_dir), 'latest')
    if os.path.lexists(link):
        if not os.path.islink(link):
            return False
        os.unlink(link)
    os.symlink(os.path.basename(log_dir), link, target_is_directory=True)
    return True


ALIASES = {'default': '[{levelname}] [{name}]: {msg}', 'default_with_timestamp': '{created:.7f} [{levelname}] [{name}]: {msg}'}


class LaunchConfig:
    """The logging configuration of one process.

    :ivar log_handler_factory: a function that is called with the path of a log file and returns the handler for it. None means
        the default file handler.
    """

    def __init__(self, root: logging.Logger) -> None:
        self._root = root
        self.dry = False
        """Whether nothing may be written: a plan creates no log files."""
        self.reset()

    def reset(self) -> None:
        """Restore the formats, level and folders that were set at the start. Loggers keep their handlers."""
        self._log_dir: str | None = None
        self.file_handlers: dict[str, Any] = {}
        self.screen_handler: Any = None
        self.log_handler_factory: Callable[[str], Any] | None = None
        self.level = logging.INFO
        self._silent_handlers: dict[str, Any] = {}
        self._screen_formatter: logging.Formatter
        self._log_formatter: logging.Formatter
        self.set_screen_format('default')
        self.set_log_format('default')

    @property
    def level(self) -> int:
        """The lowest level of records that are written."""
        return self._root.level

    @level.setter
    def level(self, new_level: Any) -> None:
        self._root.setLevel(new_level)

    @property
    def log_dir(self) -> str:
        """The folder of this launch's log files. It is created on first use, together with the symbolic link `latest` to it."""
        if self._log_dir is None:
            self._log_dir = _make_unique_log_dir(base_path=_get_logging_directory())
            _renew_latest_log_dir(log_dir=self._log_dir)
        return self._log_dir

    @log_dir.setter
    def log_dir(self, new_log_dir: str | None) -> None:
        if self.file_handlers:
            warnings.warn(
                f'Loggers have been already configured to output to log files below {self._log_dir}. Proceed at your own risk.',
                stacklevel=2,
            )
        self._log_dir = None if new_log_dir is None else _make_unique_log_dir(base_path=new_log_dir)

    @property
    def _writes_files(self) -> bool:
        if self.dry:
            return False
        if self._log_dir is not None or self.log_handler_factory is not None:
            return True
        env = environment()
        return bool(env.get('ROS_LOG_DIR') or env.get('ROS_HOME'))

    def set_screen_format(self, screen_format: str | None, *, screen_style: str | None = None) -> None:
        """Set the format of lines on the screen. OVERRIDE_LAUNCH_SCREEN_FORMAT in the environment has priority.

        :param screen_format: 'default', 'default_with_timestamp', or a format; None changes nothing.
        :raises ValueError: when a style is given for 'default' or 'default_with_timestamp'.
        """
        formatter = _formatter('screen', 'OVERRIDE_LAUNCH_SCREEN_FORMAT', screen_format, screen_style, ALIASES)
        if formatter is not None:
            self._screen_formatter = formatter
            if self.screen_handler is not None:
                self.screen_handler.setFormatter(formatter)

    def set_log_format(self, log_format: str | None, *, log_style: str | None = None) -> None:
        """Set the format of lines in log files. OVERRIDE_LAUNCH_LOG_FORMAT in the environment has priority.

        :param log_format: 'default' or a format; None changes nothing.
        :raises ValueError: when a style is given for 'default'.
        """
        aliases = {'default': ALIASES['default_with_timestamp']}
        formatter = _formatter('log', 'OVERRIDE_LAUNCH_LOG_FORMAT', log_format, log_style, aliases)
        if formatter is not None:
            self._log_formatter = formatter
            for handler in self.file_handlers.values():
                handler.setFormatter(formatter)

    def get_screen_handler(self) -> Any:
        """Return the handler that writes to the standard output of the process that first requested the handler."""
        if self.screen_handler is None:
            self.screen_handler = handlers.StreamHandler(running_process().streams.stdout)
            self.screen_handler.setFormatter(self._screen_formatter)
        return self.screen_handler

    def get_log_file_path(self, file_name: str = 'launch.log') -> str:
        """Return the path of a log file with that name."""
        return os.path.join(self.log_dir, file_name)

    def get_log_file_handler(self, file_name: str = 'launch.log') -> Any:
        """Return the handler that writes to the log file with this name. Without log files, the handler does nothing."""
        if not self._writes_files:
            return self._silent_handlers.setdefault(file_name, handlers.NullHandler())
        handler = self.file_handlers.get(file_name)
        if handler is None:
            factory = self.log_handler_factory or _file_handler
            handler = self.file_handlers[file_name] = factory(self.get_log_file_path(file_name))
            handler.setFormatter(self._log_formatter)
        return handler


def _file_handler(path: str) -> Any:
    return handlers.FileHandler(path, encoding='utf-8')


def _formatter(
    what: str, variable: str, text: str | None, style: str | None, aliases: dict[str, str]
) -> logging.Formatter | None:
    override = environment().get(variable)
    if override:
        text, style = override.encode('latin1').decode('unicode_escape'), '{'
    if text is None:
        return None
    if text in aliases:
        if style is not None and not override:
            raise ValueError(f'Cannot set a custom format style for the "{text}" {what} format.')
        text = aliases[text]
    return logging.Formatter(text, style='{' if style is None else style)  # type: ignore[arg-type]


class LaunchLogger(logging.Logger):
    """A logger that does not pass records to other loggers. Its records have simulated times."""

    def __init__(self, name: str, level: int = logging.NOTSET) -> None:
        super().__init__(name, level)
        self.propagate = False
        self._is_output = name.endswith(('-stdout', '-stderr'))

    def findCaller(self, stack_info: bool = False, stacklevel: int = 1) -> tuple[str, int, str, str | None]:
        """Return placeholders. No format of launch shows the caller, and finding it would be slow."""
        return '(unknown file)', 0, '(unknown function)', None

    def makeRecord(self, *args: Any, **kwargs: Any) -> logging.LogRecord:
        """Return a record with the simulated time."""
        record = super().makeRecord(*args, **kwargs)
        now_ns = running_process().sim.now_ns
        record.created = now_ns / 1e9
        record.msecs = now_ns // 1_000_000 % 1000
        return record

    def handle(self, record: logging.LogRecord) -> None:
        """Write the record. Unless it is a line of a program's output, also add it to the recording of the simulation."""
        if not self._is_output:
            running_process().log(record.levelno, record.name, record.getMessage())
        super().handle(record)


class LoggingState:
    """The values that upstream stores in globals: the logger `root`, the loggers below it, and the configuration `config`."""

    def __init__(self) -> None:
        self.config: LaunchConfig
        self.reset()

    def reset(self) -> None:
        """Delete all loggers and settings."""
        self.root = LaunchLogger('root', logging.INFO)
        self._manager = logging.Manager(self.root)  # type: ignore[arg-type]
        self._manager.setLoggerClass(LaunchLogger)
        self.root.manager = self._manager
        self.config = LaunchConfig(self.root)

    def get_logger(self, name: str | None = None) -> logging.Logger:
        """Return the logger of that name, without adding handlers."""
        if not name:
            return self.root
        known = self._manager.loggerDict.get(name)
        if isinstance(known, LaunchLogger):
            return known
        if '.' in name:
            return self._manager.getLogger(name)
        logger = self._manager.loggerDict[name] = LaunchLogger(name)  # avoids the locks and searches of the manager
        logger.parent = self.root
        logger.manager = self._manager
        return logger


def logging_state() -> LoggingState:
    """Return the loggers of the running process."""
    return process_state('launch.loggers', LoggingState)
