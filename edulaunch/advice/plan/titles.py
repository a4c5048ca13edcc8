"""The branches of a plan's outline, the titles of actions, and the lines below a title."""

from __future__ import annotations

import ast
import os
import re
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping
from functools import lru_cache
from typing import TYPE_CHECKING, Any

from edulaunch.ros.sources.source_package import parsed

if TYPE_CHECKING:
    from edulaunch.engine.processes import Origin

Item = dict[str, Any]
_FILE_NAME = re.compile(r"([^'/\\]+\.(?:py|xml|ya?ml))'")


class Branch:
    """An action or event of a launch, with the actions and events that follow from it.

    :param action: the action, or the description of an event.
    :ivar item: the item of the plan. None stands for an action that only contains other actions, or that was not executed.
    :ivar condition: a description of the condition, or None.
    :ivar is_taken: whether the action was executed.
    :ivar origin: the place in a launch file that created the action, or None.
    :ivar parent_origin: the place of the parent branch, or None.
    :ivar setters: for each launch configuration, the branch that last set or declared it before this action.
    """

    __slots__ = ('action', 'item', 'condition', 'is_taken', 'origin', 'parent_origin', 'setters', 'children', '_given')

    def __init__(self, action: Any, origin: Origin | None = None, condition: str | None = None) -> None:
        self.action = action
        self.origin = origin
        self.parent_origin: Origin | None = None
        self.condition = condition
        self.item: Item | None = None
        self.is_taken = False
        self.setters: Mapping[str, Branch] = {}
        self.children: list[Branch] = []
        self._given: list[Any] | None = None

    @property
    def place(self) -> Origin | None:
        """Return the place in which a reader looks for the action: the call of a function that creates the action, or its
        origin.
        """
        return None if self.origin is None else _call_of(self.action) or self.origin

    @property
    def given_parameters(self) -> list[Any]:
        """Return the result of `launch_ros.actions.Node.given_parameters()`. The result is cached, because the call is slow."""
        if self._given is None:
            self._given = self.action.given_parameters()
        return self._given

    def add(self, branch: Branch) -> Branch:
        """Append a child branch, and return it."""
        self.children.append(branch)
        branch.parent_origin = self.place
        return branch


def _call_of(action: Any) -> Origin | None:
    """Return the place of the outermost function call that created an action, or None.

    Only calls in the action's own file count, and only of functions that the file calls at several places.
    """
    found: Origin | None = None
    for name, place in action.calls:
        try:
            changed_ns = os.stat(place.file).st_mtime_ns
        except OSError:
            return None
        if _times_called(place.file, changed_ns)[name] > 1:
            found = place
    return found


@lru_cache(64)
def _times_called(file: str, changed_ns: int) -> Counter[str]:
    """Return the number of calls of each function in a Python file."""
    tree = parsed(file)
    calls = () if tree is None else (node.func for node in ast.walk(tree) if isinstance(node, ast.Call))
    return Counter(
        call.id if isinstance(call, ast.Name) else call.attr for call in calls if isinstance(call, (ast.Name, ast.Attribute))
    )


class Setters:
    """Records the branch that last set each launch configuration, while scopes open and close.

    For a declared launch configuration, this branch is the declaration. The :attr:`Branch.setters` of the declaration contain the
    earlier branch.
    """

    def __init__(self) -> None:
        self._outer: list[Mapping[str, Branch]] = []
        self._now: Mapping[str, Branch] = {}

    @property
    def now(self) -> Mapping[str, Branch]:
        """For each launch configuration, the branch that last set or declared it."""
        return self._now

    def executed(self, branch: Branch) -> None:
        """Record an action that was just executed."""
        branch.setters = now = self._now
        kind = type(branch.action).__name__
        item = branch.item
        if kind == 'PushLaunchConfigurations':
            self._outer.append(now)
        elif kind == 'PopLaunchConfigurations' and self._outer:
            self._now = self._outer.pop()
        elif kind == 'ResetLaunchConfigurations' and item is not None:
            self._now = {name: setter for name, setter in now.items() if name in item['kept']}
        elif item is not None and item['kind'] == 'unset_configuration':
            self._now = {name: setter for name, setter in now.items() if name != item['name']}
        elif item is not None and item['kind'] in ('set_configuration', 'argument'):
            self._now = {**now, item['name']: branch}


Detail = tuple[str, str]
"""The kind and the text of a line."""


def action_words(action: Any) -> tuple[str, str]:
    """Return the kind and the title of an action that was not executed, or that only contains other actions."""
    name = type(action).__name__
    if name in ('GroupAction', 'OpaqueFunction'):
        return name, 'group' if name == 'GroupAction' else 'function'
    return name, f'{name} {_subject(action)}'.rstrip()


def _subject(action: Any) -> str:
    """Return the subject of an action that was not executed, such as its program or file, if it is known."""
    for attribute in ('node_executable', 'cmd', 'launch_description_source', 'name', 'msg'):
        value = getattr(action, attribute, None)
        if value is not None:
            return _file_in(value.described_location) if hasattr(value, 'described_location') else _described(value)
    return ''


def _file_in(location: str) -> str:
    """Return the name of a launch file if substitutions describe its folder. Otherwise, return the location unchanged."""
    names = _FILE_NAME.findall(location)
    return f"'{names[-1]}'" if names and location.count("'") > 2 else location


def _described(value: Any) -> str:
    if isinstance(value, (list, tuple)):
        return ' '.join(_described(part) for part in value)
    text: str = value.describe() if hasattr(value, 'describe') else str(value)
    return text


_TITLES = {
    'include': 'include {file}',
    'argument': 'argument {name} = {value!r}',
    'set_configuration': 'set {name} = {value!r}',
    'push_namespace': 'namespace {namespace}',
    'set_env': 'environment {name} = {value!r}',
    'unset_env': 'environment {name} unset',
    'log': 'log {msg!r}',
    'timer': 'timer after {period:g} s',
    'event_handler': 'event handler {handler}',
    'set_parameter': 'parameter {name} = {value!r} for all nodes that follow',
    'set_parameters_from_file': 'parameter file {file} for all nodes that follow',
    'set_remap': 'remap {from} -> {to} for all nodes that follow',
    'emit_event': 'event {event}',
    'action': '{name}',
}


def title_of(item: Item) -> str:
    """Return the title of an action that was executed."""
    kind = item['kind']
    if kind == 'node':
        name = item['runtime_name'] or _unnamed(item['namespace'])
        return f'node {name}: {" ".join(filter(None, (item["package"], item["executable"])))}'
    if kind == 'process':
        return f'process {item["process_name"]}: {" ".join(item["cmd"])}'
    if kind == 'load_composable_nodes':
        return f'composable nodes to load: {len(item["nodes"])}'
    title: str = _TITLES.get(kind, kind.replace('_', ' ')).format(**item)
    return title


def _unnamed(namespace: str | None) -> str:
    """Return the title of a node to which the launch file gives no name, but perhaps a namespace."""
    own = "(the program's own name)"
    return own if namespace in (None, '', '/') else f'{namespace}/{own}'


def _process_details(item: Item, branch: Branch) -> Iterator[Detail]:
    if item.get('arguments'):
        yield 'arguments', f'arguments {" ".join(item["arguments"])}'
    if item.get('prefix'):
        yield 'prefix', f'prefix {" ".join(item["prefix"])}'
    for name, value in item['env_changes'].items():
        yield 'environment', f'environment {name} unset' if value is None else f'environment {name} = {value!r}'
    if item['cwd'] is not None:
        yield 'cwd', f'in the folder {item["cwd"]}'
    if item['respawn']:
        yield 'respawn', _respawn_words(item['respawn_delay'], branch.action.respawn_limit)
    if item['output'] != 'log':
        yield 'output', f'output {item["output"]}'


def _respawn_words(delay: float | None, limit: int) -> str:
    text = 'started again when it ends' + (f', {delay:g} s later' if delay else '')
    return text + (f', at most {limit} times' if limit >= 0 else '')


def _node_details(item: Item, branch: Branch) -> Iterator[Detail]:
    for old, new in item['remappings']:
        yield 'remap', f'remap {old} -> {new}'
    if item['other_ros_arguments']:
        yield 'arguments', f'ROS arguments {" ".join(item["other_ros_arguments"])}'
    yield from _process_details(item, branch)


def shown_value(value: Any) -> str:
    """Return a value as one line. A long string, such as a robot description, is shortened."""
    text = repr(value)
    return text if len(text) <= 100 else f'{text[:80]}...  [{len(text)} characters]'


def _nodes_to_load(item: Item, branch: Branch) -> Iterator[Detail]:
    for node in item['nodes']:
        full_name = f'{node["namespace"].rstrip("/")}/{node["name"] or "(its own name)"}'
        remaps = ''.join(f', remap {rule.replace(":=", " -> ")}' for rule in node['remappings'])
        yield 'composable_node', f'composable node {full_name}: {node["package"]} {node["plugin"]}{remaps}'
        for name, value in node['parameters'].items():
            yield 'parameter', f'with parameter {name} = {shown_value(value)}'


def _kept_configurations(item: Item, branch: Branch) -> Iterator[Detail]:
    for name, value in item['kept'].items():
        yield 'kept', f'but {name} = {shown_value(value)}'


def _handler_details(item: Item, branch: Branch) -> Iterator[Detail]:
    """Yield a line if the event of a handler never occurred."""
    if not branch.children:
        yield 'never', 'never happened here'


_DETAILS: dict[str, Callable[[Item, Branch], Iterable[Detail]]] = {
    'node': _node_details,
    'process': _process_details,
    'load_composable_nodes': _nodes_to_load,
    'event_handler': _handler_details,
    'reset_configurations': _kept_configurations,
}


def details_of(item: Item, branch: Branch) -> Iterable[Detail]:
    """Return the lines below the title of an executed action, except a node's parameters."""
    details = _DETAILS.get(item['kind'])
    return () if details is None else details(item, branch)
