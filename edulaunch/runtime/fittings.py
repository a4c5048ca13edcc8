"""Parts of a simulated machine and a session that other parts of edulaunch provide: the `ros2` tool, a shell, help for errors."""

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
    """Return the line of help below an error. Return None if no rule recognises the error.

    :param error: type, message, place, facts and process, as plain data.
    :param env: the environment of the program in whose terminal the user reads the error.
    """
    help: str | None = view('help_below')(error, env)
    return None if help is None else f'  help: {help}'


def help_of(error: dict[str, Any]) -> str | None:
    """Return the help for an error in one line. Return None if no rule recognises the error.

    :param error: type, message, place and facts, as plain data.
    """
    help: str | None = view('help_of')(error)
    return help


def help_of_facts(facts: dict[str, Any]) -> str:
    """Return one line of help for an error from its facts alone. Return an empty string if no rule recognises the error."""
    help: str = view('help_of_facts')(facts)
    return help
