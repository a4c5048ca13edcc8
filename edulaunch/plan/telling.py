"""A plan in words: a tree of lines."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator
from typing import Any, NamedTuple

from edulaunch.plan.outline import Branch, Item

_HIDDEN = frozenset(
    ('PushLaunchConfigurations', 'PopLaunchConfigurations', 'PushEnvironment', 'PopEnvironment', 'ResetEnvironment')
)


class Line(NamedTuple):
    """One line of the tree.

    :ivar kind: 'node', 'process', 'include' ...; 'detail' for what belongs to the line above.
    :ivar place: 'file:line' or ''.
    :ivar is_taken: False for what is left out.
    """

    kind: str
    text: str
    place: str
    is_taken: bool
    below: list[Line]


def told_launch(outline: Branch, placeholders: str | None = None) -> list[Line]:
    """The lines of a whole launch, but for the one that includes its file.

    :param placeholders: the share folder of assumed packages; paths below it are shown without it.
    """
    lines = [line for branch in outline.children[:1] for line in _told(branch)]
    return lines if placeholders is None else _without(placeholders, lines)


def _without(folder: str, lines: list[Line]) -> list[Line]:
    return [line._replace(text=line.text.replace(folder, ''), below=_without(folder, line.below)) for line in lines]


def _told(branch: Branch) -> list[Line]:
    named = {child.item['name'] for child in branch.children if child.item is not None and child.item['kind'] == 'argument'}
    return [line for child in branch.children if not _is_given_argument(child, named) for line in _lines(child)]


def _is_given_argument(branch: Branch, declared: set[str]) -> bool:
    """Whether an include sets an argument here whose own line will show the value."""
    item = branch.item
    return item is not None and item['kind'] == 'set_configuration' and branch.origin is None and item['name'] in declared


def _lines(branch: Branch) -> Iterator[Line]:
    """The line of a branch; what only holds others, and says nothing itself, gives way to them."""
    below = _told(branch)
    kind, text, details = _words(branch)
    if kind == 'event' and not _is_from_a_file(branch):
        return  # how launch itself ends a process
    is_ours = kind == 'OpaqueFunction' and branch.condition is None and (not below or branch.origin is None)
    if kind in _HIDDEN or is_ours:
        yield from below
        return
    place = '' if branch.origin is None else f'{os.path.basename(branch.origin.file)}:{branch.origin.line}'
    if branch.condition is not None:
        text = f'{text}  [{branch.condition}: {"taken" if branch.is_taken else "not taken"}]'
    elif not branch.is_taken:
        text += '  [launch stopped here]'
    under = [Line('detail', detail, '', True, []) for detail in details]
    yield Line(kind, text, place, branch.is_taken, [*under, *below])


def _is_from_a_file(branch: Branch) -> bool:
    """Whether anything below was written in a launch file."""
    return any(child.origin is not None or _is_from_a_file(child) for child in branch.children)


def _words(branch: Branch) -> tuple[str, str, list[str]]:
    """Kind, text and details of a branch."""
    item, action = branch.item, branch.action
    if isinstance(action, str):
        return 'event', action, []
    if item is not None:
        details = _DETAILS.get(item['kind'])
        return item['kind'], _title(item), [] if details is None else details(item, branch)
    name = type(action).__name__
    if name in ('GroupAction', 'OpaqueFunction'):
        return name, 'group' if name == 'GroupAction' else 'function', []
    return name, f'{name} {_subject(action)}'.rstrip(), []


def _subject(action: Any) -> str:
    """What an action that was not executed is about, as far as it is known."""
    for attribute in ('node_executable', 'cmd', 'launch_description_source', 'name', 'msg'):
        value = getattr(action, attribute, None)
        if value is not None:
            return _described(getattr(value, 'described_location', value))
    return ''


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


def _title(item: Item) -> str:
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
    """A node that the launch file gives no name, but perhaps a namespace."""
    own = "(the program's own name)"
    return own if namespace in (None, '', '/') else f'{namespace}/{own}'


def _process_details(item: Item, branch: Branch) -> list[str]:
    lines = []
    if item.get('arguments'):
        lines.append(f'arguments {" ".join(item["arguments"])}')
    if item.get('prefix'):
        lines.append(f'prefix {" ".join(item["prefix"])}')
    for name, value in item['env_changes'].items():
        lines.append(f'environment {name} unset' if value is None else f'environment {name} = {value!r}')
    if item['cwd'] is not None:
        lines.append(f'in the folder {item["cwd"]}')
    if item['respawn']:
        delay = item['respawn_delay']
        limit = branch.action.respawn_limit
        lines.append(
            'started again when it ends'
            + (f', {delay:g} s later' if delay else '')
            + (f', at most {limit} times' if limit >= 0 else '')
        )
    if item['output'] != 'log':
        lines.append(f'output {item["output"]}')
    return lines


def _node_details(item: Item, branch: Branch) -> list[str]:
    lines = []
    for name, value in item['parameters'].items():
        origin = branch.origins.get(name) or branch.file_origins.get(name)
        lines.append(f'parameter {name} = {_short(value)}' + (f'  ({origin})' if origin else ''))
    lines += [f'parameter file {path} is missing' for path in branch.missing_files]
    if 'parameter_error' in item:
        lines.append(f'parameters cannot be read: {item["parameter_error"]}')
    lines += [f'remap {old} -> {new}' for old, new in item['remappings']]
    if item['other_ros_arguments']:
        lines.append(f'ROS arguments {" ".join(item["other_ros_arguments"])}')
    return lines + _process_details(item, branch)


def _short(value: Any) -> str:
    """The value on one line; of a long text (a robot description) only the beginning."""
    text = repr(value)
    return text if len(text) <= 100 else f'{text[:80]}...  [{len(text)} characters]'


def _nodes_to_load(item: Item, branch: Branch) -> list[str]:
    lines = []
    for node in item['nodes']:
        full_name = f'{node["namespace"].rstrip("/")}/{node["name"] or "(its own name)"}'
        remaps = ''.join(f', remap {rule.replace(":=", " -> ")}' for rule in node['remappings'])
        lines.append(f'composable node {full_name}: {node["package"]} {node["plugin"]}{remaps}')
        lines += [f'with parameter {name} = {_short(value)}' for name, value in node['parameters'].items()]
    return lines


def _kept_configurations(item: Item, branch: Branch) -> list[str]:
    return [f'but {name} = {_short(value)}' for name, value in item['kept'].items()]


def _handler_details(item: Item, branch: Branch) -> list[str]:
    """Whether what a handler waits for ever came."""
    return [] if branch.children else ['never happened here']


_DETAILS: dict[str, Callable[[Item, Branch], list[str]]] = {
    'node': _node_details,
    'process': _process_details,
    'load_composable_nodes': _nodes_to_load,
    'event_handler': _handler_details,
    'reset_configurations': _kept_configurations,
}
