"""`edulaunch plan`: what a launch file would start, without starting anything."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any

from edulaunch.cli.launch import split_words
from edulaunch.launching import find_launch_file
from edulaunch.packages.discovery import workspaces_of_command
from edulaunch.session import Session

if TYPE_CHECKING:
    from edulaunch.plan import Rehearsal
    from edulaunch.plan.telling import Line

WIDEST = 10_000
"""Columns; the terminal breaks long lines better than a tree does."""
TWIGS = ('├── ', '└── ', '│   ', '    ')
ASCII_TWIGS = ('|-- ', '`-- ', '|   ', '    ')
STYLES = {
    'node': 'bold green',
    'process': 'bold green',
    'include': 'bold cyan',
    'detail': 'dim',
    'event': 'magenta',
    'timer': 'magenta',
    'event_handler': 'magenta',
    'argument': 'yellow',
}


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The launch file as for `edulaunch launch`, and how to show the plan."""
    parser.add_argument('package_or_path', metavar='PACKAGE | PATH', help='package of the launch file, or its path')
    parser.add_argument('rest', nargs='*', metavar='FILE | name:=value', help='launch file name, launch arguments')
    shape = parser.add_mutually_exclusive_group()
    shape.add_argument('--tree', action='store_true', help='as a tree (default; coloured in a terminal)')
    shape.add_argument('--json', action='store_true', help='as JSON (plan format 1)')
    parser.add_argument(
        '--assume-packages', action='store_true', help='go on when packages are missing, with empty ones instead, and say which'
    )
    parser.add_argument('--workspace', action='append', default=[], metavar='DIR', help='folder with packages; may be repeated')


def main(arguments: argparse.Namespace) -> int:
    """Print the plan. 0 when the launch file can be visited, 1 when it fails, 2 for unusable input."""
    from edulaunch.plan import rehearse

    package_or_path, file, given = split_words(arguments.package_or_path, arguments.rest)
    with Session(workspaces=workspaces_of_command(arguments.workspace, package_or_path)) as session:
        path = find_launch_file(session.index, package_or_path, file)
        host = session.host
        rehearsal = rehearse(path, given, session.index, host.env, assume_packages=arguments.assume_packages, ros2=host.ros2)
    if arguments.json:
        import json

        print(json.dumps(rehearsal.plan, indent=1, sort_keys=True))
    else:
        _show(rehearsal)
    _report(rehearsal)
    return 0 if rehearsal.plan['error'] is None else 1


def _show(rehearsal: Rehearsal) -> None:
    from edulaunch.plan.telling import told_launch

    lines = told_launch(rehearsal.outline, rehearsal.placeholders)
    if sys.stdout.isatty():
        _print_in_colour(rehearsal.plan['file'], lines)
    else:
        print('\n'.join((rehearsal.plan['file'], *_drawn(lines, _twigs()))))
    kinds = [item['kind'] for item in rehearsal.plan['items']]
    print(
        f'nodes: {kinds.count("node")}, other processes: {kinds.count("process")}, '
        f'reason of the shutdown: {rehearsal.plan["shutdown_reason"] or "none"}'
    )


def _report(rehearsal: Rehearsal) -> None:
    """What was missing, and the error, on standard error."""
    packages, others = rehearsal.missing
    if packages:
        print(f'missing packages, with placeholders instead: {", ".join(packages)}', file=sys.stderr)
    for other in others:
        print(f'missing: {other}', file=sys.stderr)
    error = rehearsal.plan['error']
    if error is not None:
        place = f'\n  at {error["origin"]}' if error.get('origin') else ''
        help = f'\n  help: {error["help"]}' if error.get('help') else ''
        print(f'error: {error["text"]}{place}{help}', file=sys.stderr)


def _drawn(lines: Sequence[Line], twigs: Sequence[str], indent: str = '') -> Iterator[str]:
    """The tree with its branches drawn."""
    through, last, beside, nothing = twigs
    for number, line in enumerate(lines, 1):
        is_last = number == len(lines)
        yield f'{indent}{last if is_last else through}{line.text}' + (f'  <{line.place}>' if line.place else '')
        yield from _drawn(line.below, twigs, indent + (nothing if is_last else beside))


def _twigs() -> Sequence[str]:
    """What to draw branches with, as far as the terminal's encoding has it."""
    try:
        ''.join(TWIGS).encode(sys.stdout.encoding or 'ascii')
    except UnicodeEncodeError:
        return ASCII_TWIGS
    return TWIGS


def _print_in_colour(title: str, lines: Sequence[Line]) -> None:
    from rich.console import Console
    from rich.text import Text
    from rich.tree import Tree

    def grow(tree: Any, below: Sequence[Line]) -> None:
        for line in below:
            label = Text(line.text, style=STYLES.get(line.kind, '') if line.is_taken else 'dim strike')
            if line.place:
                label.append(f'  <{line.place}>', style='dim')
            grow(tree.add(label), line.below)

    root = Tree(Text(title, style='bold'))
    grow(root, lines)
    Console(width=WIDEST).print(root)
