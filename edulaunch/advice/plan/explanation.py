"""Explain a plan as a tree of entries. Each entry is plain data with its place and the origin of every value.

An entry is a dictionary with `kind`, `text`, `file` and `line` (None if no launch file wrote it), `is_taken` and `children`.
Some entries contain more:

* An entry with a condition has `condition`.
* An argument has `name`, `value`, `default`, `description`, `choices` and `origin`.
* A node has `name` (None if the program chooses it), `package` and `executable`. Its children include remappings and
  parameters.
* A parameter has `name`, `value`, `origin` and `overrode`, a list of dictionaries (`value`, `origin`, `file`, `line`) for the
  overridden values.
"""

from __future__ import annotations

import os
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from edulaunch.advice.plan.titles import action_words, details_of, shown_value, title_of

if TYPE_CHECKING:
    from edulaunch.advice.plan.dry_run import Rehearsal
    from edulaunch.advice.plan.titles import Branch
    from edulaunch.engine.processes import Origin

Entry = dict[str, Any]
FORMAT = 1
HIDDEN = frozenset(
    ('PushLaunchConfigurations', 'PopLaunchConfigurations', 'PushEnvironment', 'PopEnvironment', 'ResetEnvironment')
)


def explanation_of(rehearsal: Rehearsal) -> Entry:
    """Return the explanation of a dry run as a dictionary.

    It contains `format`, `file`, `given`, `error`, `missing`, `nodes` and `processes` (the numbers of both),
    `shutdown_reason`, and the `tree`.
    """
    plan = rehearsal.plan
    kinds = [item['kind'] for item in plan['items']]
    tree = [entry for branch in rehearsal.outline.children[:1] for entry in _below(branch)]
    return {
        'format': FORMAT,
        'file': plan['file'],
        'given': plan['given'],
        'error': plan['error'],
        'missing': [*(f'package {name}' for name in rehearsal.missing[0]), *rehearsal.missing[1]],
        'nodes': kinds.count('node'),
        'processes': kinds.count('process'),
        'shutdown_reason': plan['shutdown_reason'],
        'tree': tree if rehearsal.placeholders is None else _without(rehearsal.placeholders, tree),
    }


def _without(folder: str, entries: list[Entry]) -> list[Entry]:
    """Return the entries without the folder of the placeholders for missing packages in their titles."""
    return [
        {**entry, 'text': entry['text'].replace(folder, ''), 'children': _without(folder, entry['children'])} for entry in entries
    ]


def _below(branch: Branch) -> list[Entry]:
    declared = {child.item['name'] for child in branch.children if child.item is not None and child.item['kind'] == 'argument'}
    return [entry for child in branch.children if not _is_given_argument(child, declared) for entry in _entries(child)]


def _is_given_argument(branch: Branch, declared: set[str]) -> bool:
    """Return whether a branch is an include's argument that the entry of the declared argument will show."""
    item = branch.item
    return item is not None and item['kind'] == 'set_configuration' and branch.origin is None and item['name'] in declared


def _entries(branch: Branch) -> Iterator[Entry]:
    """Yield the entry of a branch. For a branch that only contains other branches, yield the entries of these branches."""
    below = _below(branch)
    kind, text = kind_and_text(branch)
    if kind == 'event' and not _is_from_a_file(branch):
        return  # launch itself registers this handler to end a process
    is_ours = kind == 'OpaqueFunction' and branch.condition is None and (not below or branch.origin is None)
    if kind in HIDDEN or is_ours:
        yield from below
        return
    file, line = branch.place or (None, None)
    found = entry(kind, text, file, line, branch.is_taken)
    if branch.origin is not None and branch.origin != branch.place:
        found['created_line'] = branch.origin.line
    if branch.condition is not None:
        found['condition'] = branch.condition
        found['text'] += f'  [{branch.condition}: {"taken" if branch.is_taken else "not taken"}]'
    elif not branch.is_taken:
        found['text'] += '  [launch stopped here]'
    if branch.item is not None:
        add_facts(found, branch)
    found['children'] += below
    yield found


def entry(kind: str, text: str, file: str | None = None, line: int | None = None, is_taken: bool = True) -> Entry:
    """Return an entry without children."""
    return {'kind': kind, 'text': text, 'file': file, 'line': line, 'is_taken': is_taken, 'children': []}


def _is_from_a_file(branch: Branch) -> bool:
    """Return whether a launch file created any branch below this branch."""
    return any(child.origin is not None or _is_from_a_file(child) for child in branch.children)


def kind_and_text(branch: Branch) -> tuple[str, str]:
    """Return the kind and the title of a branch."""
    if isinstance(branch.action, str):
        return 'event', branch.action
    if branch.item is not None:
        return branch.item['kind'], title_of(branch.item)
    return action_words(branch.action)


def add_facts(found: Entry, branch: Branch) -> None:
    """Add the details of an executed action to the action's entry."""
    item = branch.item
    assert item is not None
    kind = item['kind']
    if kind == 'argument':
        _add_argument(found, branch)
    elif kind == 'node':
        found.update(name=item['runtime_name'], package=item['package'], executable=item['executable'])
        found['children'] += parameters_of(branch)
        found['children'] += [
            entry('missing', f'parameter file {path} is missing') for path in branch.action.missing_parameter_files()
        ]
    found['children'] += [entry(*detail) for detail in details_of(item, branch)]


def _add_argument(found: Entry, branch: Branch) -> None:
    item, action = branch.item, branch.action
    assert item is not None
    default = default_text(action)
    setter = branch.setters.get(item['name'])
    origin = 'default' if setter is None else origin_of_setter(setter)[0]
    found.update(
        name=item['name'],
        value=item['value'],
        default=default,
        description=action.description,
        choices=action.choices,
        origin=origin,
    )
    found['text'] += f'  ({origin}' + (f', instead of {default!r})' if setter is not None and default is not None else ')')


def is_declaration(branch: Branch) -> bool:
    """Return whether a branch declares a launch argument."""
    return branch.item is not None and branch.item['kind'] == 'argument'


def default_text(declaration: Any) -> str | None:
    """Return the default of a launch argument as the launch file writes it, or None if it has no default."""
    parts = declaration.default_value
    if parts is None:
        return None
    return ''.join(part.text if hasattr(part, 'text') else part.describe() for part in parts)


def origin_of_setter(setter: Branch) -> tuple[str, Origin | None]:
    """Return a description of what set a launch configuration, and its place. The command line has no place (None)."""
    before = setter.setters.get(setter.item['name']) if is_declaration(setter) and setter.item is not None else None
    if before is not None:
        return origin_of_setter(before)
    place = setter.origin or setter.parent_origin
    if place is None:
        return 'command line', None
    kind = 'include' if setter.origin is None else 'default' if is_declaration(setter) else 'set'
    return f'{kind} in {os.path.basename(place.file)} line {place.line}', place


def parameters_of(branch: Branch) -> list[Entry]:
    """Return the entries of a node's parameters. Each entry contains the values that it overrode."""
    item = branch.item
    assert item is not None
    if 'parameter_error' in item:
        return [entry('missing', f'parameters cannot be read: {item["parameter_error"]}')]
    chains: dict[str, list[Any]] = {}
    for one in branch.given_parameters:
        chain = chains.setdefault(one.name, [])
        if chain[-1:] != [one]:  # launch reports a SetParameter twice if it visits it twice
            chain.append(one)
    return [_parameter(name, item['parameters'][name], chains.get(name, [])) for name in item['parameters']]


def _parameter(name: str, value: Any, chain: list[Any]) -> Entry:
    overrode = [
        {'value': one.value, 'origin': one.origin, 'file': one.file or None, 'line': one.line or None} for one in chain[:-1]
    ]
    origin, file, line = (chain[-1].origin, chain[-1].file or None, chain[-1].line or None) if chain else ('', None, None)
    lost = ''.join(f', instead of {shown_value(one["value"])} from {one["origin"]}' for one in reversed(overrode))
    text = f'parameter {name} = {shown_value(value)}' + (f'  ({origin}{lost})' if origin else '')
    found = entry('parameter', text, file, line)
    found.update(name=name, value=value, origin=origin, overrode=overrode)
    return found


ADDED, GONE, CHANGED, SAME = '+', '-', '~', ' '


def differences(before: Entry, after: Entry) -> list[Entry]:
    """Return the entries that differ between two explanations. Each entry has a `sign`. Line numbers are not compared.

    The sign '+' marks an added entry, and '-' a removed entry. '~' marks a changed entry, whose old text is in `before`. A space
    means that only entries below this entry differ.
    """
    return _differing(before['tree'], after['tree'])


def _differing(before: list[Entry], after: list[Entry]) -> list[Entry]:
    from difflib import SequenceMatcher  # imported here, because each launch loads this module

    old, new = [_identity(entry) for entry in before], [_identity(entry) for entry in after]
    found: list[Entry] = []
    for what, start, end, new_start, new_end in SequenceMatcher(None, old, new, autojunk=False).get_opcodes():
        if what == 'equal':
            for one, other in zip(before[start:end], after[new_start:new_end], strict=True):
                found += _compared(one, other)
            continue
        found += [_whole(entry, GONE) for entry in before[start:end]]
        found += [_whole(entry, ADDED) for entry in after[new_start:new_end]]
    return found


def _identity(entry: Entry) -> tuple[Any, ...]:
    """Return a key that is equal for two entries about the same thing, even if their values differ."""
    kind = entry['kind']
    if kind in ('argument', 'parameter', 'set_configuration', 'set_parameter'):
        return kind, entry['text'].partition(' = ')[0]
    if kind == 'node':
        return kind, entry['name'], entry['package'], entry['executable']
    if kind in ('timer', 'log', 'output', 'set_env', 'environment', 'push_namespace'):
        return (kind,)
    if 'condition' in entry:
        return 'condition', entry['condition'], entry['file'], entry['line']
    return kind, entry['text']


def _compared(before: Entry, after: Entry) -> Iterator[Entry]:
    below = _differing(before['children'], after['children'])
    if before['text'] != after['text']:
        yield {**after, 'sign': CHANGED, 'before': before['text'], 'children': below}
    elif below:
        yield {**after, 'sign': SAME, 'children': below}


def _whole(entry: Entry, sign: str) -> Entry:
    return {**entry, 'sign': sign, 'children': [_whole(child, sign) for child in entry['children']]}
