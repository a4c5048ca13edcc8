"""Finds weak checks in a valid YAML rubric. A weak check gives points for a name that any node may have, or for a default that
no run shows.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import yaml

NAMED = ('ends', 'hears', 'logs', 'nodes', 'receives', 'starts')
"""Kinds of checks that search for a node by its name, and have the field `package`."""


def points_for_names(file: str) -> Iterator[str]:
    """Yield a sentence for each check of a rubric that gives points for the name of a node and requires no package.

    Checks that need a `command` check are left out, because a command of `ros2` has no package.

    :param file: the path of a valid rubric.
    """
    with open(file, encoding='utf-8') as stream:
        root = yaml.compose(stream, yaml.SafeLoader)
    commands: set[str] = set()
    for node in _part(root, 'checks').value:
        check = _plain(node)
        kind = next((name for name in check if name in (*NAMED, 'command')), None)
        is_command = kind == 'command' or not commands.isdisjoint(check.get('needs') or ())
        if is_command:
            commands.add(str(check.get('name')))
        elif kind and check.get('points') and not check[kind].get('package'):
            line = node.start_mark.line + 1
            yield f'line {line}: {kind} gives points for a name that any node may have: add package: NAME to it'


def points_for_defaults(file: str) -> Iterator[str]:
    """Yield a sentence for each check of a rubric that gives points for a default that no run shows.

    :param file: the path of a valid rubric.
    """
    with open(file, encoding='utf-8') as stream:
        root: Any = yaml.compose(stream, yaml.SafeLoader)
    runs = [] if all(key.value != 'runs' for key, _ in root.value) else [_plain(node) for node in _part(root, 'runs').value]
    left_out = {name for run in runs for name in run.get('defaults') or ()}
    for node in _part(root, 'checks').value:
        check = _plain(node)
        asked = check.get('argument')
        if not asked or not check.get('points') or 'default' not in asked:
            continue
        name, value = asked['name'], asked['default']
        line = node.start_mark.line + 1
        if name not in left_out:
            default = f'{{{name}: {value}}}'
            yield f'line {line}: no run shows the default of {name}: leave {name} out of a run that has defaults: {default}'
        elif not asked.get('shows'):
            yield f'line {line}: nothing shows the default of {name}: add shows: [CHECK], a check of what happens'


def _part(node: Any, name: str) -> Any:
    return next(value for key, value in node.value if key.value == name)


def _plain(node: Any) -> Any:
    return yaml.SafeLoader('').construct_object(node, deep=True)
