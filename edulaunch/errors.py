"""The exception classes of edulaunch::

        EdulaunchError                the base class: one message, and one line of help
        ├── UnusableInput             an invalid file, argument or value (exit code 2)
        │   ├── LaunchFileError       the launch file cannot be loaded or visited
        │   ├── RecordingError        a recording file cannot be read
        │   ├── MissingExtra          a package of an extra of edulaunch is not installed
        │   ├── InterfaceError        a .msg, .srv or .action file is invalid (interfaces/)
        │   └── PackageError          a package or executable cannot be found or read (packages/)
        ├── ForeignRosError           a real ROS 2 is on the path, so the underlay must not shadow it
        ├── SimulationError           the kernel was used incorrectly (an internal bug)
        └── RunawayProgramError       a program ran for too long without yielding

The errors of ROS 2 itself keep the types and messages of ROS 2. They are defined below `ros/python`.
"""

from __future__ import annotations

import errno

FAULTS = (
    errno.EMFILE,
    errno.ENFILE,
    errno.ENOMEM,
    errno.ENOBUFS,
    errno.EAGAIN,
    errno.ENOSPC,
    errno.EDQUOT,
    errno.EIO,
    errno.EROFS,
)
"""The numbers of errors that the computer causes, not a program."""


def fault_text(error: OSError) -> str:
    """Return the message and the help for an error of :data:`FAULTS`."""
    place = '' if error.filename is None else f': {error.filename}'
    return f'{error.strerror or error}{place}\n  help: close other programs or free disk space, and type the command again'


class EdulaunchError(Exception):
    """The base class of all errors that edulaunch raises for its users.

    :param message: what is wrong, with names and values, in one or more lines.
    :param help: one line that suggests what to do, or None if there is no suggestion.
    """

    def __init__(self, message: str, *, help: str | None = None) -> None:
        super().__init__(message)
        self.message = message
        self.help = help

    def _render_traceback_(self) -> list[str]:
        """Return the lines that a notebook shows instead of the frames of edulaunch."""
        return [f'{type(self).__name__}: {self}']

    def __str__(self) -> str:
        return self.message if self.help is None else f'{self.message}\n  help: {self.help}'


class UnusableInput(EdulaunchError):
    """An input is invalid. Commands that raise this error end with exit code 2."""


class LaunchFileError(UnusableInput):
    """A launch file cannot be loaded, or one of its actions failed."""


class MissingExtra(UnusableInput):
    """A package is not installed because it belongs to an optional extra of edulaunch.

    :param what: the feature that needs the package, such as 'ros2 bag'.
    :param package: the name of the package, such as 'rosbags'.
    :param extra: the name of the extra in `pyproject.toml`, such as 'bags'.
    """

    def __init__(self, what: str, package: str, extra: str) -> None:
        super().__init__(f'{what} needs {package}, which is not installed', help=how_to_install(extra))


def how_to_install(extra: str) -> str:
    """Return a line of help with the command that installs an extra of edulaunch."""
    return f"run this in the folder of edulaunch's setup.sh: pip install '.[{extra}]'"


class RecordingError(UnusableInput):
    """A recording file is missing or damaged, or this version of edulaunch cannot read its format."""


class InterfaceError(UnusableInput):
    """A .msg, .srv or .action file is invalid."""


class PackageError(UnusableInput):
    """A package, or something that should be in it, cannot be found or read."""


class ForeignRosError(EdulaunchError):
    """A real ROS 2 installation can be imported, so edulaunch must not put its own packages in front of it."""


class SimulationError(EdulaunchError):
    """The kernel was used incorrectly, for example to schedule an item in the past."""


class RunawayProgramError(EdulaunchError):
    """A program ran for too long without yielding. The message names the program's file and line."""
