"""The exception tree of edulaunch.

::

    EdulaunchError                what a user sees: one message, and one line of help
    ├── UnusableInput             a file, argument or value that cannot be used at all (exit code 2)
    │   ├── LaunchFileError       the launch file cannot be loaded or visited
    │   ├── RecordingError        a recording file cannot be read
    │   ├── MissingExtra          a package of an extra of edulaunch is not installed
    │   ├── InterfaceError        a .msg, .srv or .action text is wrong (interfaces/)
    │   └── PackageError          a package or executable cannot be found or read (packages/)
    ├── ForeignRosError           a real ROS 2 is on the path, so the underlay must not shadow it
    ├── SimulationError           the kernel was used wrongly (an internal mistake)
    └── RunawayProgramError       a program never gave its turn back

Errors that ROS 2 itself raises keep ROS 2's own types and texts; they live in the faces under `ros/python`.
"""

from __future__ import annotations


class EdulaunchError(Exception):
    """Base of all errors that edulaunch raises for its user.

    :param message: what is wrong, naming the thing, in one or more lines.
    :param help: one line that says what to try, or None.
    """

    def __init__(self, message: str, *, help: str | None = None) -> None:
        super().__init__(message)
        self.message = message
        self.help = help

    def _render_traceback_(self) -> list[str]:
        """What a notebook shows instead of the frames of edulaunch."""
        return [f'{type(self).__name__}: {self}']

    def __str__(self) -> str:
        return self.message if self.help is None else f'{self.message}\n  help: {self.help}'


class UnusableInput(EdulaunchError):
    """What was given cannot be used at all; commands end with exit code 2."""


class LaunchFileError(UnusableInput):
    """A launch file cannot be loaded, or an action in it failed while it was visited."""


class MissingExtra(UnusableInput):
    """A package is not installed, because only one of the extras of edulaunch brings it.

    :param what: what needs the package: 'ros2 bag'.
    :param package: the name of the package: 'rosbags'.
    :param extra: the name of the extra in `pyproject.toml`: 'bags'.
    """

    def __init__(self, what: str, package: str, extra: str) -> None:
        super().__init__(f'{what} needs {package}, which is not installed', help=how_to_install(extra))


def how_to_install(extra: str) -> str:
    """Return the line of help that says how to install an extra of edulaunch."""
    return f"run this in the folder of edulaunch's setup.sh: pip install '.[{extra}]'"


class RecordingError(UnusableInput):
    """A recording file is missing, damaged, or of a format that this version does not read."""


class InterfaceError(UnusableInput):
    """The text of a .msg, .srv or .action file cannot be understood."""


class PackageError(UnusableInput):
    """A package, or something that should be in it, cannot be found or read."""


class ForeignRosError(EdulaunchError):
    """A real ROS 2 installation is importable; the underlay refuses to shadow it."""


class SimulationError(EdulaunchError):
    """The kernel was asked for something that makes no sense, such as scheduling into the past."""


class RunawayProgramError(EdulaunchError):
    """A program kept its turn for too long; names the file and line it was at."""
