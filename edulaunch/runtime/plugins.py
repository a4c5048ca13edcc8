"""Plug-ins: what adds verbs, options, packages and rules to edulaunch without being known to it.

An entry point of the group `edulaunch.plugins` names a :class:`Plugin`, in the `pyproject.toml` of whoever brings it. To read the
entry points of all that is installed takes some 30 ms. So it is done once in a process, and only when a word is not built in, for
help and completion, and by those who need all plug-ins of a kind.
"""

from __future__ import annotations

import sys
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from functools import cache
from importlib import import_module
from importlib.util import find_spec
from typing import TYPE_CHECKING, Any, NamedTuple

from edulaunch.errors import UnusableInput

if TYPE_CHECKING:
    from importlib.metadata import EntryPoint

GROUP = 'edulaunch.plugins'


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


@dataclass(frozen=True)
class Plugin:
    """What a plug-in adds. Modules are named, and loaded when they are used.

    :ivar needs: modules of other plug-ins without which it is not there.
    :ivar verbs: verbs of `edulaunch`.
    :ivar grading: verbs of `edugrade`.
    :ivar options: options of a command, `launch` or `ros2 launch`: a module with `add_options(parser)` and what the command
        calls: `session_class(arguments)` for `launch`, `begin(arguments, process)` for `ros2 launch`.
    :ivar services: what answers inside the machine: the module that makes it. `edulaunch.desk.machine.on_network` says what the
        service `network` has.
    :ivar functions: functions that the package `edulaunch` offers in the plug-in's place: `module:function`.
    """

    needs: tuple[str, ...] = ()
    verbs: Mapping[str, Verb] = field(default_factory=dict)
    grading: Mapping[str, GradingVerb] = field(default_factory=dict)
    options: Mapping[str, str] = field(default_factory=dict)
    services: Mapping[str, str] = field(default_factory=dict)
    functions: Mapping[str, str] = field(default_factory=dict)


class Source(NamedTuple):
    """Which of our own plug-ins brings something, and how it is installed."""

    plugin: str
    install: str


_NETWORK = "pip install --force-reinstall 'edulaunch[network]'"
_EDULAUNCH = 'pip install --force-reinstall edulaunch'
SOURCES = {
    'edulaunch compare': Source('comparing', _NETWORK),
    'edulaunch course': Source('course', _EDULAUNCH),
    'edulaunch launch --network': Source('network', _NETWORK),
    'edulaunch launch --real': Source('network', _NETWORK),
    'edulaunch network': Source('network', _NETWORK),
    'ros2 launch --network': Source('network', _NETWORK),
    'edulaunch.check': Source('grader', _EDULAUNCH),
    **{
        f'edugrade {verb}': Source('classes', _EDULAUNCH)
        for verb in ('batch', 'classroom', 'doctor', 'export', 'gradescope', 'sign', 'similar', 'verify')
    },
}
"""What our own plug-ins bring, so that one that is asked for and not there can be named."""


@cache
def plugins() -> dict[str, Plugin]:
    """The plug-ins that are here, by name. One that cannot be loaded is named in a warning on standard error."""
    from importlib.metadata import entry_points

    found = {}
    for entry in sorted(entry_points(group=GROUP), key=lambda entry: entry.name):
        plugin = _loaded(entry)
        if plugin is not None and all(map(is_here, plugin.needs)):
            found[entry.name] = plugin
    return found


def _loaded(entry: EntryPoint) -> Plugin | None:
    """The plug-in; None when its folder was taken away, or when it is broken."""
    try:
        plugin = entry.load()
    except Exception as error:
        if not (isinstance(error, ModuleNotFoundError) and f'{entry.module}.'.startswith(f'{error.name}.')):
            _warn(entry, f'{type(error).__name__}: {error}')
        return None
    if isinstance(plugin, Plugin):
        return plugin
    _warn(entry, f'{entry.value} is no edulaunch.runtime.plugins.Plugin')
    return None


def _warn(entry: EntryPoint, why: str) -> None:
    owner = entry.dist.name if entry.dist is not None else entry.module
    print(f'warning: the plug-in {entry.name!r} of {owner} cannot be used: {why}', file=sys.stderr)
    print(f'  help: repair {entry.module}, or remove it: pip uninstall {owner}', file=sys.stderr)


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


def options_of_plugins(command: str) -> Iterator[Any]:
    """The modules with options that plug-ins add to a command."""
    return (import_module(plugin.options[command]) for plugin in plugins().values() if command in plugin.options)


def service(name: str) -> Any | None:
    """The module that makes a service of the machine; None when no plug-in brings it."""
    return next((import_module(plugin.services[name]) for plugin in plugins().values() if name in plugin.services), None)


def function(place: str) -> Any:
    """What `module:function` names."""
    module, _, name = place.partition(':')
    return getattr(import_module(module), name)


def absent(what: str) -> UnusableInput | None:
    """The error for what one of our own plug-ins would bring if it was here; None for anything else.

    :param what: a command and its verb or option: 'edulaunch network', 'ros2 launch --network'.
    """
    source = SOURCES.get(what)
    if source is None:
        return None
    return UnusableInput(
        f'{what} needs the plug-in {source.plugin!r}, which is not installed.', help=f'install it: {source.install}'
    )
