"""`edulaunch completion SHELL`: the script that lets a shell complete `edulaunch`, `edugrade` and `ros2` with the Tab key."""

from __future__ import annotations

import argparse
from pathlib import Path

SHELLS = Path(__file__).with_name('shells')
SCRIPTS = {shell: (SHELLS / f'completion.{shell}').read_text('utf-8') for shell in ('bash', 'fish', 'zsh')}


def completion_arguments(parser: argparse.ArgumentParser) -> None:
    """The shell; and what the script asks for."""
    parser.add_argument('shell', choices=sorted(SCRIPTS), help='print the script for this shell')
    parser.add_argument('--line', metavar='TEXT', help='print what could stand at the end of this line (the script asks so)')


def completion_verb(arguments: argparse.Namespace) -> int:
    """Print the script, or the candidates, one on a line."""
    if arguments.line is None:
        print(SCRIPTS[arguments.shell], end='')
        return 0
    from edulaunch.desk.cli.candidates import candidates

    for candidate in candidates(arguments.line, break_words=arguments.shell == 'bash'):
        print(candidate)
    return 0
