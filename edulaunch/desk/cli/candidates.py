"""Completion candidates for an unfinished `edulaunch`, `edugrade` or `ros2` command line."""

from __future__ import annotations

import argparse
import os
import re
import shlex
import sys
from collections.abc import Callable, Iterable, Sequence
from contextlib import suppress
from typing import TYPE_CHECKING, Any

from edulaunch.desk.cli import arguments_of, options_of
from edulaunch.desk.cli.plugin_options import HELP, add_plugin_options
from edulaunch.engine.processes.current import current_process
from edulaunch.errors import UnusableInput
from edulaunch.runtime.launching import LAUNCH_SUFFIXES, find_launch_file, launch_files_of

if TYPE_CHECKING:
    from edulaunch.engine.packages import Index

LAUNCHING = ('launch', 'explain', 'plan')
"""Verbs that take a launch file."""
LONGEST_S = 2.0
"""Completion waits this many seconds for a busy machine."""
LISTED = {'topic_name': 'topic list', 'topics': 'topic list', 'service_name': 'service list', 'action_name': 'action list'}
LISTED |= {'node_name': 'node list', 'container_node_name': 'component list --containers-only'}
"""The commands that list the values of an argument, by the name of the argument."""
TYPES = {'topic_type': '-m', 'message_type': '-m', 'service_type': '-s', 'action_type': '-a', 'type': ''}
"""The option of `ros2 interface list` for arguments that are types."""
Run = Callable[[str], Sequence[str]]


def candidates(line: str, *, break_words: bool) -> list[str]:
    """Return the candidates that can replace the last word of a line, in alphabetical order.

    :param line: the command line up to the cursor.
    :param break_words: whether the shell splits words at `:` and `=`, as bash does. If True, return only the part of each
        candidate after its last split.
    """
    words = _split(line)
    typed = words.pop()
    command = os.path.basename(words[0]) if words else ''
    words = words[1:]
    if command == 'edulaunch' and words[:1] == ['ros2']:
        command, words = 'ros2', words[1:]
    if command == 'edugrade':
        possible = _grading_words(words, typed)
    else:
        possible = ros2_words(words, typed) if command == 'ros2' else _possible(words, typed)
    found = sorted({word for word in possible if word.startswith(typed)})
    kept = max(typed.rfind(':'), typed.rfind('=')) + 1 if break_words else 0
    return [word[kept:] for word in found]


def _split(line: str) -> list[str]:
    """Return the words of the line. The last word is empty if the line ends with a space."""
    try:
        words = shlex.split(line)
    except ValueError:
        words = line.split()  # the line has an open quote
    if not words or line[-1:].isspace():
        words.append('')
    return words


def ros2_words(
    words: Sequence[str], typed: str, index: Callable[[], Index] | None = None, run: Callable[[str], Sequence[str]] | None = None
) -> Iterable[str]:
    """Return the words that can come next after `ros2 WORDS...`. `ros2 launch` is completed like `edulaunch launch`.

    :param words: the complete words after `ros2`.
    :param typed: the beginning of the word that the user is typing.
    :param index: a function that returns the package index (default: the packages of this terminal and folder).
    :param run: a function that returns the lines that a command prints (default: run the command on the running machine).
    """

    if words[:1] == ['launch'] and not typed.startswith('-'):
        return _possible(words, typed, index)
    return ros2_candidates(words, typed, index or _index_here, run)


def _index_here() -> Index:
    from edulaunch.engine.packages.discovery import find_workspaces
    from edulaunch.runtime.session import index_for

    return index_for(find_workspaces(os.getcwd(), os.environ))


def _possible(words: Sequence[str], typed: str, index: Callable[[], Index] | None = None) -> Iterable[str]:
    from edulaunch.desk.cli.main import VERBS, all_verbs
    from edulaunch.desk.cli.main import load as load_verb

    if not words:
        return [*all_verbs(), '--help', '--version']
    verb = words[0]
    if verb not in VERBS and verb not in all_verbs():
        return []
    parser = argparse.ArgumentParser(prog=verb)
    load_verb(verb)[0](parser)
    _add_plugin_options(verb, parser, words[1:], typed)
    parser = _command_of(parser, words[1:])
    options = options_of(parser)
    if typed.startswith('-'):
        return options
    last = options.get(words[-1])
    if last is not None and last.nargs != 0:
        return _option_values(last, typed)
    return _launch_words(words, options, typed, index) if verb in LAUNCHING else [*_choices(parser), *_paths(typed)]


def _grading_words(words: Sequence[str], typed: str) -> Iterable[str]:
    """Return the verbs, options, option values and paths for `edugrade WORDS...`. Return an empty list without the grader."""
    from edulaunch.runtime import plugins

    verbs = plugins.grading_verbs()
    parser = plugins.parser_of('edugrade')
    if parser is None:
        return []
    is_first = not words
    if words[:1] and words[0] in verbs:
        verb, *words = words
        place = verbs[verb].parser
        parser = _command_of(plugins.function(place)() if place else argparse.ArgumentParser(), words)
    options = options_of(parser)
    if typed.startswith('-'):
        return options
    last = options.get(words[-1]) if words else None
    if last is not None and last.nargs != 0:
        return map(str, _option_values(last, typed))
    return [*(verbs if is_first else _choices(parser)), *_paths(typed)]


def _command_of(parser: argparse.ArgumentParser, words: Sequence[str]) -> argparse.ArgumentParser:
    """Return the parser of the sub-command with which the words begin, or the given parser if there is no such sub-command."""
    inner: list[Any] = [action.choices for action in arguments_of(parser) if isinstance(action.choices, dict)]
    return next((commands[words[0]] for commands in inner if words and words[0] in commands), parser)


def _add_plugin_options(command: str, parser: argparse.ArgumentParser, words: Sequence[str], typed: str) -> None:
    """Add the options of plug-ins to the parser if the command line contains an option that needs them."""
    with suppress(UnusableInput):  # the option belongs to a plug-in that is not installed
        add_plugin_options(command, parser, [*words, *(HELP[:1] if typed.startswith('-') else ())])


def _option_values(option: Any, typed: str) -> Iterable[str]:
    if option.dest == 'workspace':
        return [path for path in _paths(typed) if path.endswith('/')]
    return option.choices or _paths(typed)


def _choices(parser: argparse.ArgumentParser) -> list[str]:
    """Return the values that the positional arguments of a parser accept."""
    return [str(word) for action in arguments_of(parser) if not action.option_strings for word in action.choices or ()]


def _launch_words(words: Sequence[str], options: dict[str, Any], typed: str, found: Callable[[], Index] | None) -> Iterable[str]:
    """Return the candidates for the next positional word of a `launch` command.

    The first word is a package or a launch file. After a package comes one of its launch files, and then come launch arguments.
    """
    positional, workspaces = [], []
    rest = iter(words[1:])
    for word in rest:
        option = options.get(word)
        if option is None:
            positional.append(word)
        elif option.nargs != 0:
            value = next(rest, '')
            workspaces += [value] if option.dest == 'workspace' else []
    from edulaunch.engine.packages.discovery import workspaces_of_command
    from edulaunch.runtime.session import index_for

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
    """Return `name:=` for each launch argument. If the user has typed `name:=`, return the choices of that argument."""
    from edulaunch.ros.sourcing import source

    source()
    from ros2launch.api.api import load_launch_file

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
    """Return the folders (ending in a slash) and files whose paths begin with the typed word."""
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


def ros2_candidates(words: Sequence[str], typed: str, index: Callable[[], Index], run: Run | None = None) -> Iterable[str]:
    """Return the words that can come next after `ros2 WORDS...`.

    :param words: the complete words after `ros2`.
    :param typed: the beginning of the word that the user is typing.
    :param index: a function that returns the index of the packages of this terminal and folder.
    :param run: a function that returns the lines that a `ros2` command prints (default: run it on the running machine).
    """
    from edulaunch.desk.cli.ros2.commands import COMMANDS

    if not words:
        return [*COMMANDS, '--help']
    verbs = COMMANDS.get(words[0], ('', {}))[1]
    if verbs and len(words) == 1:
        return [*verbs, '--help']
    if words[0] not in COMMANDS or (verbs and words[1] not in verbs):
        return []
    parser = _ros2_parser(words[0], words[1] if verbs else '')
    if words[0] == 'launch':
        _add_plugin_options('ros2 launch', parser, words[1:], typed)
    options = options_of(parser)
    rest = list(words[1 + bool(verbs) :])
    if typed.startswith('-') and '--ros-args' not in rest:
        return options
    place = _place(parser, rest)
    return [] if place is None else _values(place, [word for word in rest if not word.startswith('-')], index, run or on_machine)


def _ros2_parser(command: str, verb: str) -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(prog='ros2')
    from edulaunch.desk.cli.ros2.commands import load

    load(command, verb or None).add_arguments(parser)
    return parser


def _place(parser: argparse.ArgumentParser, words: Sequence[str]) -> argparse.Action | None:
    """Return the argparse action of the next word: the last option if it still needs a value, or the next positional argument."""
    places = [action for action in arguments_of(parser) if not action.option_strings]
    options, position, wanted = options_of(parser), 0, None
    for word in words:
        option = options.get(word)
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
    """Return the lines that a command prints on the running machine.

    Return no lines if no machine runs, if the command fails, or if it does not end in time.
    """
    import subprocess

    words = [
        sys.executable,
        '-c',
        'import sys; from edulaunch.desk.machine.client import run; sys.exit(run(sys.argv[1:], start=False))',
    ]
    try:
        done = subprocess.run(
            [*words, 'ros2', *line.split()], capture_output=True, text=True, stdin=subprocess.DEVNULL, timeout=LONGEST_S
        )
    except (OSError, subprocess.TimeoutExpired):
        return []
    return done.stdout.splitlines() if done.returncode == 0 else []
