"""Parts that wings above provide to a simulated machine and a session: the `ros2` tool, a shell, help for errors."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from edulaunch.engine.processes.commands import CommandSet
from edulaunch.engine.recording.views import view
from edulaunch.runtime import ros2_command
from edulaunch.runtime.shell import SimulatedShell


def command_set() -> CommandSet:
    """Return the commands of a machine with ROS 2."""
    return CommandSet({'ros2': ros2_command.run}, SimulatedShell())


def hint_of(error: dict[str, Any], env: Mapping[str, str]) -> str | None:
    """Return the line of help below an error; None if no rule recognises it.

    :param error: type, message, place, facts and process, as plain data.
    :param env: the environment of the program in whose terminal the user reads it.
    """
    help: str | None = view('help_below')(error, env)
    return None if help is None else f'  help: {help}'


def help_of(error: dict[str, Any]) -> str | None:
    """Return the help for an error as plain data (type, message, place, facts), in one line; None if no rule recognises it."""
    help: str | None = view('help_of')(error)
    return help


def help_of_facts(facts: dict[str, Any]) -> str:
    """Return one line of help for an error from its facts alone; an empty string if no rule recognises it."""
    help: str = view('help_of_facts')(facts)
    return help
