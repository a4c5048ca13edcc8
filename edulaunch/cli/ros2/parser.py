"""Command lines: argparse as ros2cli uses it, written to the streams of the running process."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Sequence
from typing import Any, NoReturn

from edulaunch.cli.ros2.commands import COMMANDS, NOT_HERE, Verb, load
from edulaunch.cli.ros2.output import with_help
from edulaunch.nearest import nearest
from edulaunch.processes.current import current_process

WIDTH = 100
BUFFERING = '--use-python-default-buffering'
BUFFERING_HELP = f"""  {BUFFERING}
                        accepted; each line is written at once, whoever reads it
"""


class Parser(argparse.ArgumentParser):
    """A parser that writes where the simulated program writes, of a fixed width."""

    def __init__(self, prog: str, description: str) -> None:
        super().__init__(
            prog=prog, description=description, formatter_class=lambda prog: argparse.HelpFormatter(prog, width=WIDTH)
        )

    def _print_message(self, message: str, file: Any = None) -> None:
        process = current_process()
        (process.stderr if file is sys.stderr else process.stdout).write(message)

    def parse(self, words: Sequence[str]) -> argparse.Namespace:
        """As `parse_args`, but optional words may stand behind options too: argparse allows that in newer
        Pythons only."""
        arguments, others = self.parse_known_args(words)
        for action in self._get_positional_actions():
            if action.nargs == '*':
                while others and not others[0].startswith('-'):
                    getattr(arguments, action.dest).append(others.pop(0))
            elif (
                action.nargs == '?'
                and others
                and getattr(arguments, action.dest) == action.default
                and not others[0].startswith('-')
            ):
                setattr(arguments, action.dest, others.pop(0))
        if others:
            self.error(f'unrecognized arguments: {" ".join(others)}')
        return arguments

    def error(self, message: str) -> NoReturn:
        """Usage and message on standard error, with the nearest option when one is unknown; status 2."""
        self.print_usage(sys.stderr)
        unknown = message.partition('unrecognized arguments: ')[2].split()
        near = nearest(unknown[0], self._option_string_actions) if unknown and unknown[0].startswith('-') else None
        self.exit(2, with_help(f'{self.prog}: error: {message}', near and f'did you mean {near}?') + '\n')


def command_line(words: Sequence[str]) -> tuple[Verb, argparse.Namespace]:
    """What does as `ros2 WORDS...` says, and its arguments.

    :raises SystemExit: 0 after showing help, 2 after an error.
    """
    words = words[words[:1] == [BUFFERING] :]
    command = _chosen('ros2', 'command', words, {name: text for name, (text, _) in COMMANDS.items()})
    text, verbs = COMMANDS[command]
    prog, rest = f'ros2 {command}', words[1:]
    verb = None
    if verbs:
        verb = _chosen(prog, 'verb', rest, verbs, text)
        prog, text, rest = f'{prog} {verb}', verbs[verb], rest[1:]
    parser = Parser(prog, text)
    parser.set_defaults(verb=verb)
    found = load(command, verb)
    found.add_arguments(parser)
    return found, parser.parse(rest)


def _chosen(prog: str, kind: str, words: Sequence[str], known: dict[str, str], text: str = '') -> str:
    """The first word, which must be one of the known ones; without one, help is shown."""
    option = '' if text else f' [{BUFFERING}]'
    usage = f'usage: {prog} [-h]{option} Call `{prog} <{kind}> -h` for more detailed usage. ...\n'
    if not words or words[0] in ('-h', '--help'):
        about = text or 'ros2 is an extensible command-line tool for ROS 2.'
        options = '  -h, --help            show this help message and exit\n' + ('' if text else BUFFERING_HELP)
        title = f'{usage}\n{about}\n\noptions:\n{options}\nCommands:\n'
        current_process().stdout.write(f'{title}{_listed(known)}\n  Call `{prog} <{kind}> -h` for more detailed usage.\n')
        raise SystemExit(0)
    word = words[0]
    if word in known:
        return word
    near = nearest(word, known)
    choices = ', '.join(repr(name) for name in known)
    message = with_help(
        f'{prog}: error: argument Call `{prog} <{kind}> -h` for more detailed usage.: invalid choice: {word!r} '
        f'(choose from {choices})',
        (NOT_HERE.get(word) if prog == 'ros2' else None) or (near and f'did you mean `{prog} {near}`?'),
    )
    current_process().stderr.write(f'{usage}{message}\n')
    raise SystemExit(2)


def _listed(known: dict[str, str]) -> str:
    width = max(map(len, known))
    return ''.join(f'  {name:<{width}}  {text}\n' for name, text in known.items())
