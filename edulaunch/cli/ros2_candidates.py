"""What could stand at the end of an unfinished `ros2` command line: verbs, options, packages, names of the running machine."""

from __future__ import annotations

import argparse
import os
import re
import subprocess
import sys
from collections.abc import Callable, Iterable, Sequence
from typing import TYPE_CHECKING

from edulaunch.cli.ros2.commands import COMMANDS, load

if TYPE_CHECKING:
    from edulaunch.packages import Index

LONGEST_S = 2.0
"""Seconds after which a busy machine is not waited for any longer."""
LISTED = {'topic_name': 'topic list', 'topics': 'topic list', 'service_name': 'service list', 'action_name': 'action list'}
LISTED |= {'node_name': 'node list', 'container_node_name': 'component list --containers-only'}
"""The commands that list what an argument can be, by the name of the argument."""
TYPES = {'topic_type': '-m', 'message_type': '-m', 'service_type': '-s', 'action_type': '-a', 'type': ''}
"""The option of `ros2 interface list` for arguments that are types."""
Run = Callable[[str], Sequence[str]]


def candidates(words: Sequence[str], typed: str, index: Callable[[], Index], run: Run | None = None) -> Iterable[str]:
    """Words that could come behind `ros2 WORDS...`.

    :param index: gives the packages that are found from here.
    :param run: gives the lines that a `ros2` command prints (default: on the running machine, if there is one).
    """
    if not words:
        return [*COMMANDS, '--help']
    verbs = COMMANDS.get(words[0], ('', {}))[1]
    if verbs and len(words) == 1:
        return [*verbs, '--help']
    if words[0] not in COMMANDS or (verbs and words[1] not in verbs):
        return []
    parser = _parser(words[0], words[1] if verbs else '')
    options = parser._option_string_actions
    rest = list(words[1 + bool(verbs) :])
    if typed.startswith('-') and '--ros-args' not in rest:
        return options
    place = _place(parser, rest)
    return [] if place is None else _values(place, [word for word in rest if not word.startswith('-')], index, run or on_machine)


def _parser(command: str, verb: str) -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(prog='ros2')
    load(command, verb or None).add_arguments(parser)
    return parser


def _place(parser: argparse.ArgumentParser, words: Sequence[str]) -> argparse.Action | None:
    """The argument that comes next: that of the last option, or the next one without an option."""
    places = parser._get_positional_actions()
    position, wanted = 0, None
    for word in words:
        option = parser._option_string_actions.get(word)
        if wanted is None and option is None and not word.startswith('-'):
            position += 1
        wanted = option if wanted is None and option is not None and option.nargs != 0 else None
    if wanted is not None:
        return wanted
    return places[min(position, len(places) - 1)] if places and (position < len(places) or places[-1].nargs) else None


def _values(place: argparse.Action, given: Sequence[str], index: Callable[[], Index], run: Run) -> Iterable[str]:
    name = place.dest
    if place.choices:
        return map(str, place.choices)
    if name == 'package_name':
        return index().packages()
    if name == 'executable_name':
        return index().executables(given[0])
    if name in ('parameter_name', 'parameter_names'):
        return [line.strip() for line in run(f'param list {given[0]}')]
    if name in TYPES:
        known = _type_of(given[0], run) if name == 'message_type' and given else []
        return known or [line.strip() for line in run(f'interface list {TYPES[name]}') if '/' in line]
    return run(LISTED[name]) if name in LISTED else _files()


def _type_of(topic: str, run: Run) -> Sequence[str]:
    return [line for line in run(f'topic type {topic}') if re.fullmatch(r'\w+/msg/\w+', line)]


def _files() -> list[str]:
    return sorted(entry.name + '/' * entry.is_dir() for entry in os.scandir() if not entry.name.startswith('.'))


def on_machine(line: str) -> list[str]:
    """The lines that a command prints on the running machine; none when there is no machine, or it is too busy."""
    words = [
        sys.executable,
        '-c',
        'import sys; from edulaunch.machine.client import run; sys.exit(run(sys.argv[1:], start=False))',
    ]
    try:
        done = subprocess.run(
            [*words, 'ros2', *line.split()], capture_output=True, text=True, stdin=subprocess.DEVNULL, timeout=LONGEST_S
        )
    except (OSError, subprocess.TimeoutExpired):
        return []
    return done.stdout.splitlines() if done.returncode == 0 else []
