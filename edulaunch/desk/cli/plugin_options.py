"""Options that plug-ins add to a command, such as `ros2 launch --network` and `edulaunch launch --real`."""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from typing import Any

from edulaunch.desk.cli import options_of

HELP = ('-h', '--help')


def add_plugin_options(command: str, parser: argparse.ArgumentParser, words: Sequence[str]) -> None:
    """Add the options of plug-ins to a parser. Load plug-ins only if a word asks for help, or is an option that the parser lacks.

    :param command: 'launch' or 'ros2 launch'.
    :param words: the words that the parser will read.
    :raises UnusableInput: for an option of one of edulaunch's own plug-ins that is not installed.
    """
    known = options_of(parser)
    asked = [word.partition('=')[0] for word in words if word.startswith('-')]
    unknown = [word for word in asked if word not in known]
    if not unknown and not set(asked) & set(HELP):
        return
    from edulaunch.runtime.plugins import absent, options_of_plugins

    modules = list(options_of_plugins(command))
    for module in modules:
        module.add_options(parser)
    parser.set_defaults(plugins=modules)
    for word in unknown:
        error = absent(f'{"" if command.startswith("ros2") else "edulaunch "}{command} {word}')
        if error is not None and word not in options_of(parser):
            raise error


def plugins_of(arguments: argparse.Namespace) -> list[Any]:
    """Return the modules of the plug-ins whose options the parser has."""
    return getattr(arguments, 'plugins', [])
