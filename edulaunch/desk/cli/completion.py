"""`edulaunch completion SHELL`: print the script that makes a shell complete `edulaunch`, `edugrade` and `ros2` with Tab."""

from __future__ import annotations

import argparse
from pathlib import Path

SHELLS = Path(__file__).with_name('shells')
SCRIPTS = {shell: (SHELLS / f'completion.{shell}').read_text('utf-8') for shell in ('bash', 'fish', 'zsh')}


def completion_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the argument for the shell, and the option that the completion script uses."""
    parser.add_argument('shell', choices=sorted(SCRIPTS), help='print the script for this shell')
    parser.add_argument('--line', metavar='TEXT', help='print the candidates for the end of this line (for the script)')


def completion_verb(arguments: argparse.Namespace) -> int:
    """Print the completion script. With `--line`, print one candidate per line instead."""
    if arguments.line is None:
        print(SCRIPTS[arguments.shell], end='')
        return 0
    from edulaunch.desk.cli.candidates import candidates

    for candidate in candidates(arguments.line, break_words=arguments.shell == 'bash'):
        print(candidate)
    return 0
