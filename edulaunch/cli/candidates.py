"""What could stand at the end of an unfinished `edulaunch` command line."""

from __future__ import annotations

import argparse
import os
import shlex
from collections.abc import Callable, Iterable, Sequence
from importlib import import_module
from typing import TYPE_CHECKING, Any

from edulaunch.launching import LAUNCH_SUFFIXES, find_launch_file, launch_files_of

if TYPE_CHECKING:
    from edulaunch.packages import Index

LAUNCHING = ('launch', 'explain', 'plan')
"""Verbs that take a launch file."""


def candidates(line: str, *, break_words: bool) -> list[str]:
    """Words that could stand in place of the last one, in alphabetical order.

    :param line: the command line up to the cursor.
    :param break_words: the shell sees words end behind `:` and `=`, as bash does; only what follows is given.
    """
    words = _split(line)
    typed = words.pop()
    command = os.path.basename(words[0]) if words else ''
    words = words[1:]
    if command == 'edulaunch' and words[:1] == ['ros2']:
        command, words = 'ros2', words[1:]
    possible = ros2_words(words, typed) if command == 'ros2' else _possible(words, typed)
    found = sorted({word for word in possible if word.startswith(typed)})
    kept = max(typed.rfind(':'), typed.rfind('=')) + 1 if break_words else 0
    return [word[kept:] for word in found]


def _split(line: str) -> list[str]:
    """The words of the line; the last one may be empty."""
    try:
        words = shlex.split(line)
    except ValueError:
        words = line.split()  # a quote is open
    if not words or line[-1:].isspace():
        words.append('')
    return words


def ros2_words(
    words: Sequence[str], typed: str, index: Callable[[], Index] | None = None, run: Callable[[str], Sequence[str]] | None = None
) -> Iterable[str]:
    """Words that could come behind `ros2 WORDS...`: for `launch` as for `edulaunch launch`; else see `ros2_candidates`.

    :param index: gives the packages (default: those that are found from here).
    :param run: gives the lines that a command prints (default: on the running machine).
    """
    from edulaunch.cli import ros2_candidates

    if words[:1] == ['launch'] and not typed.startswith('-'):
        return _possible(words, typed, index)
    return ros2_candidates.candidates(words, typed, index or _index_here, run)


def _index_here() -> Index:
    from edulaunch.packages.discovery import find_workspaces
    from edulaunch.session import index_for

    return index_for(find_workspaces(os.getcwd(), os.environ))


def _possible(words: Sequence[str], typed: str, index: Callable[[], Index] | None = None) -> Iterable[str]:
    from edulaunch.cli.main import VERBS

    if not words:
        return [*VERBS, '--help', '--version']
    verb = words[0]
    if verb not in VERBS:
        return []
    parser = argparse.ArgumentParser(prog=verb)
    import_module(f'edulaunch.cli.{verb}').add_arguments(parser)
    options = {text: action for action in parser._actions for text in action.option_strings}
    if typed.startswith('-'):
        return options
    last = options.get(words[-1])
    if last is not None and last.nargs != 0:
        return _option_values(last, typed)
    return _launch_words(words, options, typed, index) if verb in LAUNCHING else [*_choices(parser), *_paths(typed)]


def _option_values(option: Any, typed: str) -> Iterable[str]:
    if option.dest == 'workspace':
        return [path for path in _paths(typed) if path.endswith('/')]
    return option.choices or _paths(typed)


def _choices(parser: argparse.ArgumentParser) -> list[str]:
    """The words that a positional argument is limited to."""
    return [str(word) for action in parser._actions if not action.option_strings for word in action.choices or ()]


def _launch_words(words: Sequence[str], options: dict[str, Any], typed: str, found: Callable[[], Index] | None) -> Iterable[str]:
    """Packages and launch files; then launch files of the package; then launch arguments."""
    positional, workspaces = [], []
    rest = iter(words[1:])
    for word in rest:
        option = options.get(word)
        if option is None:
            positional.append(word)
        elif option.nargs != 0:
            value = next(rest, '')
            workspaces += [value] if option.dest == 'workspace' else []
    from edulaunch.packages.discovery import workspaces_of_command
    from edulaunch.session import index_for

    if found is not None:
        index = found()
    else:
        index = index_for(workspaces_of_command([path for path in workspaces if os.path.isdir(path)], (*positional, '')[0]))
    if not positional:
        return [*index.packages(), *_paths(typed, LAUNCH_SUFFIXES)]
    by_path = os.path.isfile(positional[0])
    if not by_path and len(positional) == 1:
        return launch_files_of(index, positional[0])
    return _arguments(index, positional[0], None if by_path else positional[1], typed)


def _arguments(index: Index, first: str, file: str | None, typed: str) -> list[str]:
    """`name:=` of each launch argument; behind that its choices."""
    from edulaunch.sourcing import source

    source()
    from ros2launch.api.api import load_launch_file

    from edulaunch.processes.current import current_process

    process = current_process()
    before, process.index = process.index, index
    process.host.index = index
    try:
        arguments = load_launch_file(find_launch_file(index, first, file)).get_launch_arguments()
    except Exception:
        return []  # a launch file that cannot be loaded has no arguments to offer
    finally:
        process.index = process.host.index = before
    name, sign, _ = typed.partition(':=')
    if sign:
        return [f'{name}:={value}' for argument in arguments if argument.name == name for value in argument.choices or ()]
    return [f'{argument.name}:=' for argument in arguments]


def _paths(typed: str, suffixes: tuple[str, ...] = ()) -> list[str]:
    """Folders (with a slash behind) and files, as far as they are typed."""
    folder, start = os.path.split(typed)
    try:
        entries = sorted(os.scandir(folder or '.'), key=lambda entry: entry.name)
    except OSError:
        return []
    found = []
    for entry in entries:
        if not entry.name.startswith('.') or start.startswith('.'):
            path = os.path.join(folder, entry.name)
            if entry.is_dir():
                found.append(path + '/')
            elif not suffixes or entry.name.endswith(suffixes):
                found.append(path)
    return found
