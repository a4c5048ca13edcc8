"""What a recording keeps of a launch besides its processes, in the state of the process that runs launch."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from ._engine import process_state

if TYPE_CHECKING:
    from edulaunch.processes import Origin

    from .actions.declare_launch_argument import DeclareLaunchArgument


def note_declared(argument: DeclareLaunchArgument) -> None:
    """A launch argument was declared; the first declaration of a name is kept, in `launch.declared`."""
    declared: list[DeclareLaunchArgument] = process_state('launch.declared', list)
    if all(argument.name != known.name for known in declared):
        declared.append(argument)


def note_include(path: str) -> None:
    """A launch file was included; its path goes to `launch.includes`."""
    includes: list[str] = process_state('launch.includes', list)
    includes.append(path)


def note_undeclared(names: Iterable[str], declared: Iterable[str], file: str, origin: Origin | None) -> None:
    """Arguments were given to an included file that declares no such argument; ROS 2 sets them in silence.

    They are kept in `launch.undeclared`.
    """
    known = list(declared)
    noted: list[tuple[str, list[str], str, Origin | None]] = process_state('launch.undeclared', list)
    noted += [(name, known, file, origin) for name in names if name not in known]


def names_read() -> dict[str, bool]:
    """The names of launch configurations that substitutions asked for (`launch.read`), in order."""
    return process_state('launch.read', dict)
