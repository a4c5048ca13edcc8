"""What a simulated machine and a session get from the rooms above: the `ros2` tool, a shell, help for errors."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from edulaunch.engine.processes.commands import CommandSet
from edulaunch.engine.recording.views import view
from edulaunch.runtime import ros2_command
from edulaunch.runtime.shell import SimulatedShell


def command_set() -> CommandSet:
    """The commands of a machine on which ROS 2 is installed."""
    return CommandSet({'ros2': ros2_command.run}, SimulatedShell())


def hint_of(error: dict[str, Any], env: Mapping[str, str]) -> str | None:
    """The line of help below an error; None when no rule knows it.

    :param error: type, message, place, facts and process, as plain data.
    :param env: of the program in whose terminal it is read.
    """
    help: str | None = view('help_below')(error, env)
    return None if help is None else f'  help: {help}'


def help_of(error: dict[str, Any]) -> str | None:
    """The help for an error as plain data (type, message, place, facts), in one line; None when no rule knows it."""
    help: str | None = view('help_of')(error)
    return help


def help_of_facts(facts: dict[str, Any]) -> str:
    """The help for an error of which only facts are known, in one line; '' when there are none."""
    help: str = view('help_of_facts')(facts)
    return help
