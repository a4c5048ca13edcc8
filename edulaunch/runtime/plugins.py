"""Plug-ins: packages that add verbs, options, packages and rules to edulaunch, although edulaunch does not depend on these
packages.

An entry point of the group `edulaunch.plugins` in the `pyproject.toml` of a package names a :class:`Plugin`. A process searches
for plug-ins at most once. Unknown words, help, completion, and code that needs all plug-ins of a kind cause the search.
`importlib.metadata` takes 50 ms to load and 20 ms to search. So this module itself reads `entry_points.txt` in each folder of
metadata on the path, as the packaging standard defines it. That takes 2 ms.
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

    :ivar about: the line about the verb in `--help`.
    :ivar module: the module with the functions `VERB_arguments(parser)` and `VERB_verb(arguments)`, which returns the exit code.
    """

    about: str
    module: str


class GradingVerb(NamedTuple):
    """A verb of the grader.

    :ivar function: the function for the words after the verb, as `module:function`. It returns the exit code.
    :ivar example: an example call for `edugrade --help`, without the leading `edugrade`.
    :ivar about: the purpose of the example.
    :ivar parser: `module:function` that returns the parser of the words after the verb, for completion.
    """

    function: str
    example: str
    about: str
    parser: str = ''


class Plugin(NamedTuple):
    """The contents of a plug-in. It contains names of modules, which are imported on first use.

    :ivar needs: modules of other plug-ins. If one of them is missing, this plug-in counts as missing.
    :ivar verbs: verbs of `edulaunch`.
    :ivar grading: verbs of `edugrade`.
    :ivar options: options of a command (`launch`, `ros2 launch` or `view`): a module with `add_options(parser)`. The command also
        calls `session_class(arguments)` for `launch`, `begin(arguments, process)` for `ros2 launch`, and `view(arguments)` for
        `view`, which returns what to serve in place of the page.
    :ivar services: the module that creates each service of the machine. `edulaunch.desk.machine.network` defines the
        service `network`. For any other service, `peer(machine, connection)` returns the peer of a connection.
    :ivar packages: folders with ROS packages in source form, which are searched after the student's packages.
    :ivar rules: modules with rules of advice, by their subject: one of `edulaunch.advice.rule.KINDS`.
    :ivar templates: functions (`module:function`) that create files for a course, for `edulaunch course template NAME`. A
        function runs in the folder of the course. It receives the content of requirements.txt and (name, path) of each
        exercise, and returns the files by path.
    :ivar parsers: other commands that the Tab key completes, each with the function that returns its parser: `module:function`.
    :ivar functions: functions that the package `edulaunch` offers from the plug-in: `module:function`.
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


class Provider(NamedTuple):
    """The plug-in of edulaunch that provides a feature, and how to install this plug-in."""

    plugin: str
    install: str


_NETWORK = "pip install --force-reinstall '.[network]' in the folder of edulaunch's setup.sh"
_EDULAUNCH = "pip install --force-reinstall . in the folder of edulaunch's setup.sh"
_EDITOR = "pip install --force-reinstall '.[editor]' in the folder of edulaunch's setup.sh"
SOURCES = {
    'edulaunch compare': Provider('comparing', _NETWORK),
    'edulaunch course': Provider('course', _EDULAUNCH),
    'edulaunch course template classroom': Provider('classes', _EDULAUNCH),
    'edulaunch course template gradescope': Provider('classes', _EDULAUNCH),
    'edulaunch course template vscode': Provider('editor', _EDITOR),
    'edulaunch launch --network': Provider('network', _NETWORK),
    'edulaunch launch --real': Provider('network', _NETWORK),
    'edulaunch lsp': Provider('editor', _EDITOR),
    'edulaunch.foxglove': Provider('foxglove', _EDULAUNCH),
    'edulaunch view --foxglove': Provider('foxglove', _EDULAUNCH),
    'edulaunch network': Provider('network', _NETWORK),
    'ros2 launch --network': Provider('network', _NETWORK),
    'edulaunch.check': Provider('grader', _EDULAUNCH),
    **{f'edugrade {verb}': Provider('grader', _EDULAUNCH) for verb in ('course', 'decoys', 'schema')},
    **{
        f'edugrade {verb}': Provider('classes', _EDULAUNCH)
        for verb in ('batch', 'classroom', 'doctor', 'export', 'gradescope', 'sign', 'similar', 'verify')
    },
}
"""The contents of our own plug-ins, so that errors can name a missing one."""


@cache
def plugins() -> dict[str, Plugin]:
    """Return the installed plug-ins by name. Print a warning for a plug-in that cannot be loaded."""
    return _usable(lambda name: True)


@cache
def plugins_of_others() -> dict[str, Plugin]:
    """Return third-party plug-ins by name. edulaunch's own plug-ins have no packages and no rules, so a run need not load
    them.
    """
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
    """An entry point: its name, its object (`module:object`), and its distribution."""

    name: str
    place: str
    owner: str


def entries() -> Iterator[Entry]:
    """Return the entry points of the group in all distributions that are folders on the path.

    The current folder does not count, because `python -m` puts it on the path, and it may contain a submission.
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
    """Return the plug-in, or None if its folder was deleted or it is broken."""
    module = entry.place.partition(':')[0]
    try:
        plugin = function(entry.place)
    except Exception as error:
        if not (isinstance(error, ModuleNotFoundError) and f'{module}.'.startswith(f'{error.name}.')):
            _warn(entry, f'{type(error).__name__}: {error}')
        return None
    if isinstance(plugin, Plugin):
        return plugin
    _warn(entry, f'{entry.place} is not an edulaunch.runtime.plugins.Plugin')
    return None


def _warn(entry: Entry, why: str) -> None:
    print(f'warning: the plug-in {entry.name!r} of {entry.owner} cannot be used: {why}', file=sys.stderr)
    print(f'  help: fix {entry.place.partition(":")[0]}, or remove it: pip uninstall {entry.owner}', file=sys.stderr)


def is_here(module: str) -> bool:
    """Return whether a module can be imported. The result may be False because the folder of the module was deleted."""
    try:
        spec = find_spec(module)
    except ModuleNotFoundError:
        return False
    return spec is not None and spec.origin is not None


def verbs() -> dict[str, Verb]:
    """Return the verbs of `edulaunch` from plug-ins."""
    return {word: verb for plugin in plugins().values() for word, verb in plugin.verbs.items()}


def grading_verbs() -> dict[str, GradingVerb]:
    """Return the verbs of `edugrade` from plug-ins."""
    return {word: verb for plugin in plugins().values() for word, verb in plugin.grading.items()}


def offered(name: str) -> Any:
    """Return a function that a plug-in provides for the package `edulaunch`, such as `edulaunch.check`.

    :raises UnusableInput: when no plug-in provides it.
    """
    place = next((plugin.functions[name] for plugin in plugins().values() if name in plugin.functions), None)
    if place is None:
        raise absent(f'edulaunch.{name}') or UnusableInput(f'no plug-in provides edulaunch.{name}')
    return function(place)


def parser_of(command: str) -> Any | None:
    """Return the parser of another command from a plug-in, such as `edugrade`. Return None if no plug-in provides it."""
    return next((function(plugin.parsers[command])() for plugin in plugins().values() if command in plugin.parsers), None)


def options_of_plugins(command: str) -> Iterator[Any]:
    """Return the modules with options that plug-ins add to a command."""
    return (import_module(plugin.options[command]) for plugin in plugins().values() if command in plugin.options)


def package_folders() -> list[str]:
    """Return the folders with ROS packages from plug-ins."""
    return [folder for plugin in plugins_of_others().values() for folder in plugin.packages]


def modules_with_rules(kind: str) -> list[Any]:
    """Return the modules with rules of advice from plug-ins for one kind of subject."""
    return [import_module(plugin.rules[kind]) for plugin in plugins_of_others().values() if kind in plugin.rules]


def template(name: str) -> Any | None:
    """Return the function that creates the files of a template for courses. Return None if no plug-in provides it."""
    return next((function(plugin.templates[name]) for plugin in plugins().values() if name in plugin.templates), None)


def service(name: str) -> Any | None:
    """Return the module that creates a service of the machine. Return None if no plug-in provides it."""
    return next((import_module(plugin.services[name]) for plugin in plugins().values() if name in plugin.services), None)


def function(place: str) -> Any:
    """Return the object that `module:function` names."""
    module, _, name = place.partition(':')
    return getattr(import_module(module), name)


def _lacking(name: str) -> str:
    """Return the name of the first missing plug-in that the plug-in `name` needs. If none of these is missing, return `name`."""
    found = next((_loaded(entry) for entry in entries() if entry.name == name), None)
    lacking = [need for need in found.needs if not is_here(need)] if found is not None else []
    return lacking[0].rpartition('.')[2] if lacking else name


def absent(what: str) -> UnusableInput | None:
    """Return the error for a feature if one of edulaunch's own plug-ins provides it and is missing. Return None for any other
    feature.

    :param what: a command and its verb or option, such as 'edulaunch network' or 'ros2 launch --network'.
    """
    source = SOURCES.get(what)
    if source is None:
        return None
    missing = f'{what} needs the plug-in {_lacking(source.plugin)!r}, which is not installed.'
    return UnusableInput(missing, help=f'install it: {source.install}')
