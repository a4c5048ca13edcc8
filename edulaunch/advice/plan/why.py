"""Explain a value: find the chain from the first value to the effective value.

A step is a dictionary with `value`, `origin` (a description), `file` and `line` (or None), and `counts` (True for the last step).
`argument` contains the steps of the launch argument that determines the value.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from typing import TYPE_CHECKING, Any

from launch_ros._parameter_origins import argument_in

from edulaunch.advice.plan.explanation import default_text, is_declaration, origin_of_setter
from edulaunch.engine.nearest import did_you_mean
from edulaunch.errors import UnusableInput

if TYPE_CHECKING:
    from edulaunch.advice.plan.titles import Branch

Step = dict[str, Any]
_OF_ARGUMENT = 'launch argument '


def branches(outline: Branch) -> Iterator[Branch]:
    """Yield all branches of an outline, in order."""
    for child in outline.children:
        yield child
        yield from branches(child)


def nodes_named(outline: Branch, name: str) -> list[Branch]:
    """Return the nodes with this name. If the launch file gives a node no name, the node has the name of its executable.

    :raises UnusableInput: when no node has this name.
    """
    nodes = [branch for branch in branches(outline) if branch.item is not None and branch.item['kind'] == 'node']
    wanted = '/' + name.strip('/')
    found = [branch for branch in nodes if wanted == name_of(branch)]
    if not found:
        names = sorted({name_of(branch) for branch in nodes})
        help = did_you_mean(wanted, names) or (f'it starts {", ".join(names)}' if names else 'it starts no node')
        raise UnusableInput(f"the launch file starts no node '{wanted}'.", help=help)
    return found


def name_of(branch: Branch) -> str:
    """Return the full name of a node. If the launch file gives it no name, use the name of its executable."""
    item = branch.item
    assert item is not None
    return item['runtime_name'] or f'{(item["namespace"] or "").rstrip("/")}/{item["executable"]}'


def parameter_chain(node: Branch, parameter: str, default: Step | None = None) -> list[Step]:
    """Return the steps of one parameter of a node, or an empty list if no value is set.

    :param node: the branch of the node.
    :param parameter: the name of the parameter.
    :param default: a step with the default that the program declares, or None if it is unknown.
    """
    steps = [] if default is None else [default]
    for one in node.given_parameters:
        if one.name == parameter:
            below = _steps_of_argument(node.setters, one.origin)
            step = _step(one.value, one.origin, one.file or None, one.line or None, below)
            if steps[-1:] != [step]:
                steps.append(step)
    return _with_winner(steps)


def argument_chain(outline: Branch, name: str) -> list[Step]:
    """Return the steps of a launch argument for the launch file that declares it first.

    :raises UnusableInput: when no launch file declares the argument.
    """
    declared = [branch for branch in branches(outline) if is_declaration(branch)]
    names = [branch.item['name'] for branch in declared if branch.item is not None]
    if name in names:
        return declared_steps(declared[names.index(name)])
    names = sorted(set(names))
    help = did_you_mean(name, names) or (f'its arguments are {", ".join(names)}' if names else 'it declares no argument')
    raise UnusableInput(f"there is no launch argument '{name}' in this launch file.", help=help)


def _step(value: Any, origin: str, file: str | None, line: int | None, argument: Iterable[Step] = ()) -> Step:
    return {'value': value, 'origin': origin, 'file': file, 'line': line, 'counts': False, 'argument': list(argument)}


def _with_winner(steps: list[Step]) -> list[Step]:
    for step in steps[-1:]:
        step['counts'] = True
    return steps


def _steps_of_argument(setters: Mapping[str, Branch], origin: str) -> list[Step]:
    if not origin.startswith(_OF_ARGUMENT):
        return []
    setter = setters.get(origin[len(_OF_ARGUMENT) :])
    return [] if setter is None else setter_steps(setter)


def declared_steps(declaration: Branch) -> list[Step]:
    """Return the default of a launch argument, and the values that replaced the default."""
    item, action = declaration.item, declaration.action
    assert item is not None
    setter = declaration.setters.get(item['name'])
    default = default_text(action)
    file, line = declaration.origin or (None, None)
    own = [] if default is None else [_step(item['value'] if setter is None else default, 'default', file, line)]
    return _with_winner([*own, *([] if setter is None else setter_steps(setter))])


def setter_steps(setter: Branch) -> list[Step]:
    """Return the steps that set a launch configuration: a declaration, an include, an action, or the command line."""
    if is_declaration(setter):
        return declared_steps(setter)
    item = setter.item
    assert item is not None
    words, place = origin_of_setter(setter)
    file, line = (None, None) if place is None else place
    origin = argument_in(getattr(setter.action, 'value', None)) or ''
    return _with_winner([_step(item['value'], words, file, line, _steps_of_argument(setter.setters, origin))])
