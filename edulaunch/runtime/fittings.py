"""What every simulated machine is fitted with from the rooms above the engine: the `ros2` tool, a shell, hints below errors."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from edulaunch.engine.attached import attached
from edulaunch.engine.processes.commands import CommandSet
from edulaunch.runtime.shell import SimulatedShell


def command_set() -> CommandSet:
    """The commands of a machine on which ROS 2 is installed."""
    return CommandSet({'ros2': lambda process: attached('ros2')(process)}, SimulatedShell())


def hint_of(error: dict[str, Any], env: Mapping[str, str]) -> str | None:
    """The line of help below an error; None when no rule knows it.

    :param error: type, message, place, facts and process, as plain data.
    :param env: of the program in whose terminal it is read.
    """
    help: str | None = attached('help_below')(error, env)
    return None if help is None else f'  help: {help}'
