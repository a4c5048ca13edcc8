"""What a recording keeps of a launch besides its processes, in the state of the process that runs launch."""

from __future__ import annotations

import os
from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

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

    They are kept in `launch.undeclared`, for :func:`undeclared_warnings`.
    """
    known = list(declared)
    noted: list[tuple[str, list[str], str, Origin | None]] = process_state('launch.undeclared', list)
    noted += [(name, known, file, origin) for name in names if name not in known]


def undeclared_warnings(state: dict[str, Any]) -> list[str]:
    """One line for each undeclared argument that nothing has read.

    :param state: of the process that ran launch.
    """
    lines = []
    for name, declared, file, origin in state.get('launch.undeclared', ()):
        if name not in state.get('launch.read', ()):
            from edulaunch.nearest import nearest

            near = nearest(name, declared)
            known = f'it declares: {", ".join(declared)}' if declared else 'it declares none'
            place = '' if origin is None else f' at {os.path.basename(origin.file)}:{origin.line}'
            lines.append(
                f"launch argument '{name}', given to {os.path.basename(file)}{place}, is not declared there; "
                + (f"did you mean '{near}'?" if near is not None else known)
            )
    return list(dict.fromkeys(lines))


def names_read() -> dict[str, bool]:
    """The names of launch configurations that substitutions asked for (`launch.read`), in order."""
    return process_state('launch.read', dict)
