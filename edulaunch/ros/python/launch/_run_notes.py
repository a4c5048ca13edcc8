"""Records of a launch for the recording of the run. They are stored in the state of the process that runs launch."""

from __future__ import annotations

from collections.abc import Iterable
from types import FunctionType
from typing import TYPE_CHECKING, Any, Protocol

from ._engine import process_state

if TYPE_CHECKING:
    from edulaunch.engine.processes import Origin


class Declared(Protocol):
    """The part of a `DeclareLaunchArgument` that this module needs."""

    @property
    def name(self) -> str:
        """The name of the argument."""


def note_declared(argument: Declared) -> None:
    """Record the first declaration of a launch argument in `launch.declared`."""
    declared: list[Declared] = process_state('launch.declared', list)
    if all(argument.name != known.name for known in declared):
        declared.append(argument)


def note_include(path: str) -> None:
    """Record the path of an included launch file in `launch.includes`."""
    includes: list[str] = process_state('launch.includes', list)
    includes.append(path)


def note_undeclared(names: Iterable[str], declared: Iterable[str], file: str, origin: Origin | None) -> None:
    """Add the arguments that an included file does not declare to `launch.undeclared`. ROS 2 sets them without a message."""
    known = list(declared)
    rows: list[tuple[str, list[str], str, Origin | None]] = process_state('launch.undeclared', list)
    rows += [(name, known, file, origin) for name in names if name not in known]


def names_read() -> dict[str, bool]:
    """Return the names of launch configurations that substitutions have read (`launch.read`), in the order of the first read."""
    return process_state('launch.read', dict)


_KEY = 'launch.wrong_return'


def note_wrong_return(function: Any) -> None:
    """Store the function for :func:`tell_wrong_return`."""
    remembered: list[Any] = process_state(_KEY, list)
    remembered[:] = [function] if isinstance(function, FunctionType) else []


def tell_wrong_return(error: Any) -> None:
    """Attach the file and line of the last stored function to the error."""
    remembered: list[Any] = process_state(_KEY, list)
    for function in remembered:
        code = function.__code__
        error.edulaunch_file, error.edulaunch_line = code.co_filename, code.co_firstlineno
