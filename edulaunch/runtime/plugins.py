"""Plug-ins: what adds verbs, options, packages and rules to edulaunch without being known to it.

An entry point of the group `edulaunch.plugins` names a :class:`Plugin`, in the `pyproject.toml` of whoever brings it. They are
looked for once in a process: when a word is not built in, for help and completion, and by those who need all plug-ins of a kind.
`importlib.metadata` would take 50 ms to be loaded and 20 ms to look. So this file reads `entry_points.txt` of each folder of
metadata on the path by itself, as the packaging standard describes that file, in 2 ms.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Callable, Iterator, Mapping
from functools import cache
from importlib import import_module
from importlib.util import find_spec
from types import MappingProxyType
from typing import Any, NamedTuple

from edulaunch.errors import UnusableInput

GROUP = 'edulaunch.plugins'
NOTHING: Mapping[str, Any] = MappingProxyType({})


class Verb(NamedTuple):
    """A verb of the command line.

    :ivar about: its line in `--help`.
    :ivar module: the module with the functions `VERB_arguments(parser)` and `VERB_verb(arguments)`, which returns the exit code.
    """

    about: str
    module: str


class GradingVerb(NamedTuple):
    """A verb of the grader.

    :ivar function: the function of the words behind the verb that returns the exit code: `module:function`.
    :ivar example: how it is called, for `edugrade --help`, without `edugrade` in front.
    :ivar about: what that does.
    """

    function: str
    example: str
    about: str


class Plugin(NamedTuple):
    """What a plug-in adds. Modules are named, and loaded when they are used.

    :ivar needs: modules of other plug-ins without which it is not there.
    :ivar verbs: verbs of `edulaunch`.
    :ivar grading: verbs of `edugrade`.
    :ivar options: options of a command, `launch`, `ros2 launch` or `view`. The module has `add_options(parser)` and the function
        that the command calls. `launch` calls `session_class(arguments)`, and `ros2 launch` calls `begin(arguments, process)`.
        `view` calls `view(arguments)`, which returns what to serve in place of the page.
    :ivar services: what answers inside the machine: the module that makes it. `edulaunch.desk.machine.network` says what the
        service `network` has. Of any other one, `peer(machine, connection)` returns who talks on a connection.
    :ivar packages: folders with ROS packages in source form, which are found behind those of the student.
    :ivar rules: modules with rules of advice, by what they look at: one of `edulaunch.advice.rule.KINDS`.
    :ivar templates: files for a course, for `edulaunch course template NAME`: `module:function`. It is called in the folder of
        the course with the text of requirements.txt and (name, path) of each exercise, and returns the files by path.
    :ivar parsers: other commands that the Tab key completes, each with the function that returns its parser: `module:function`.
    :ivar functions: functions that the package `edulaunch` offers in the plug-in's place: `module:function`.
    """

    needs: tuple[str, ...] = ()
    verbs: Mapping[str, Verb] = NOTHING
    grading: Mapping[str, GradingVerb] = NOTHING
    options: Mapping[str, str] = NOTHING
    services: Mapping[str, str] = NOTHING
    packages: tuple[str, ...] = ()
    rules: Mapping[str, str] = NOTHING
    templates: Mapping[str, str] = NOTHING
    parsers: Mapping[str, str] = NOTHING
    functions: Mapping[str, str] = NOTHING


class Source(NamedTuple):
    """Which of our own plug-ins brings something, and how it is installed."""

    plugin: str
    install: str


_NETWORK = "pip install --force-reinstall '.[network]' in the folder of edulaunch's setup.sh"
_EDULAUNCH = "pip install --force-reinstall . in the folder of edulaunch's setup.sh"
_EDITOR = "pip install --force-reinstall '.[editor]' in the folder of edulaunch's setup.sh"
SOURCES = {
    'edulaunch compare': Source('comparing', _NETWORK),
    'edulaunch course': Source('course', _EDULAUNCH),
    'edulaunch course template classroom': Source('classes', _EDULAUNCH),
    'edulaunch course template gradescope': Source('classes', _EDULAUNCH),
    'edulaunch course template vscode': Source('editor', _EDITOR),
    'edulaunch launch --network': Source('network', _NETWORK),
    'edulaunch launch --real': Source('network', _NETWORK),
    'edulaunch lsp': Source('editor', _EDITOR),
    'edulaunch view --foxglove': Source('foxglove', _EDULAUNCH),
    'edulaunch network': Source('network', _NETWORK),
    'ros2 launch --network': Source('network', _NETWORK),
    'edulaunch.check': Source('grader', _EDULAUNCH),
    **{f'edugrade {verb}': Source('grader', _EDULAUNCH) for verb in ('course', 'decoys', 'schema')},
    **{
        f'edugrade {verb}': Source('classes', _EDULAUNCH)
        for verb in ('batch', 'classroom', 'doctor', 'export', 'gradescope', 'sign', 'similar', 'verify')
    },
}
"""What our own plug-ins bring, so that one that is asked for and not there can be named."""


@cache
def plugins() -> dict[str, Plugin]:
    """The plug-ins that are here, by name. One that cannot be loaded is named in a warning on standard error."""
    return _usable(lambda name: True)


@cache
def plugins_of_others() -> dict[str, Plugin]:
    """Those of somebody else, by name. Our own bring no packages and no rules, and so a run need not load them."""
    ours = {source.plugin for source in SOURCES.values()}
    return _usable(lambda name: name not in ours)


def _usable(is_wanted: Callable[[str], bool]) -> dict[str, Plugin]:
    found: dict[str, Plugin] = {}
    for entry in sorted(entries()):
        plugin = _loaded(entry) if is_wanted(entry.name) else None
        if plugin is not None and all(map(is_here, plugin.needs)):
            found.setdefault(entry.name, plugin)
    return found


class Entry(NamedTuple):
    """An entry point: its name, `module:object`, and which distribution has it."""

    name: str
    place: str
    owner: str


def entries() -> Iterator[Entry]:
    """The entry points of the group in all distributions that are installed as folders on the path.

    The current folder is none of them: `python -m` puts it on the path, and what lies there may be a submission.
    """
    here = os.path.realpath(os.curdir)
    for folder in sys.path:
        if os.path.realpath(folder) == here:
            continue
        try:
            names = os.listdir(folder)
        except OSError:
            continue
        for name in names:
            if name.endswith(('.dist-info', '.egg-info')):
                yield from _entries_of(os.path.join(folder, name, 'entry_points.txt'), name.partition('-')[0])


def _entries_of(path: str, owner: str) -> Iterator[Entry]:
    try:
        with open(path, encoding='utf-8') as file:
            text = file.read()
    except (OSError, ValueError):
        return
    section = text.partition(f'[{GROUP}]')[2].partition('\n[')[0]
    for line in section.splitlines():
        name, sign, place = line.partition('=')
        if sign and not line.startswith(('#', ';')):
            yield Entry(name.strip(), place.strip(), owner)


@cache
def _loaded(entry: Entry) -> Plugin | None:
    """The plug-in; None when its folder was taken away, or when it is broken."""
    module = entry.place.partition(':')[0]
    try:
        plugin = function(entry.place)
    except Exception as error:
        if not (isinstance(error, ModuleNotFoundError) and f'{module}.'.startswith(f'{error.name}.')):
            _warn(entry, f'{type(error).__name__}: {error}')
        return None
    if isinstance(plugin, Plugin):
        return plugin
    _warn(entry, f'{entry.place} is no edulaunch.runtime.plugins.Plugin')
    return None


def _warn(entry: Entry, why: str) -> None:
    print(f'warning: the plug-in {entry.name!r} of {entry.owner} cannot be used: {why}', file=sys.stderr)
    print(f'  help: repair {entry.place.partition(":")[0]}, or remove it: pip uninstall {entry.owner}', file=sys.stderr)


def is_here(module: str) -> bool:
    """Whether a module can be imported; its folder may have been taken away."""
    try:
        spec = find_spec(module)
    except ModuleNotFoundError:
        return False
    return spec is not None and spec.origin is not None


def verbs() -> dict[str, Verb]:
    """The verbs of `edulaunch` that plug-ins bring."""
    return {word: verb for plugin in plugins().values() for word, verb in plugin.verbs.items()}


def grading_verbs() -> dict[str, GradingVerb]:
    """The verbs of `edugrade` that plug-ins bring."""
    return {word: verb for plugin in plugins().values() for word, verb in plugin.grading.items()}


def offered(name: str) -> Any:
    """A function that the package `edulaunch` offers in a plug-in's place, such as `edulaunch.check`.

    :raises UnusableInput: when no plug-in brings it.
    """
    place = next((plugin.functions[name] for plugin in plugins().values() if name in plugin.functions), None)
    if place is None:
        raise absent(f'edulaunch.{name}') or UnusableInput(f'no plug-in brings edulaunch.{name}')
    return function(place)


def parser_of(command: str) -> Any | None:
    """The parser of another command that a plug-in brings, such as `edugrade`; None when no plug-in brings it."""
    return next((function(plugin.parsers[command])() for plugin in plugins().values() if command in plugin.parsers), None)


def options_of_plugins(command: str) -> Iterator[Any]:
    """The modules with options that plug-ins add to a command."""
    return (import_module(plugin.options[command]) for plugin in plugins().values() if command in plugin.options)


def package_folders() -> list[str]:
    """The folders with ROS packages that plug-ins bring."""
    return [folder for plugin in plugins_of_others().values() for folder in plugin.packages]


def modules_with_rules(kind: str) -> list[Any]:
    """The modules with rules of advice that plug-ins bring for one kind of thing."""
    return [import_module(plugin.rules[kind]) for plugin in plugins_of_others().values() if kind in plugin.rules]


def template(name: str) -> Any | None:
    """The function that makes the files of a template for courses; None when no plug-in brings it."""
    return next((function(plugin.templates[name]) for plugin in plugins().values() if name in plugin.templates), None)


def service(name: str) -> Any | None:
    """The module that makes a service of the machine; None when no plug-in brings it."""
    return next((import_module(plugin.services[name]) for plugin in plugins().values() if name in plugin.services), None)


def function(place: str) -> Any:
    """What `module:function` names."""
    module, _, name = place.partition(':')
    return getattr(import_module(module), name)


def _lacking(name: str) -> str:
    """The plug-in itself, or the one that it needs and that is not here."""
    found = next((_loaded(entry) for entry in entries() if entry.name == name), None)
    lacking = [need for need in found.needs if not is_here(need)] if found is not None else []
    return lacking[0].rpartition('.')[2] if lacking else name


def absent(what: str) -> UnusableInput | None:
    """The error for what one of our own plug-ins would bring if it was here; None for anything else.

    :param what: a command and its verb or option: 'edulaunch network', 'ros2 launch --network'.
    """
    source = SOURCES.get(what)
    if source is None:
        return None
    missing = f'{what} needs the plug-in {_lacking(source.plugin)!r}, which is not installed.'
    return UnusableInput(missing, help=f'install it: {source.install}')
