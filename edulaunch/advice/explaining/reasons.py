"""Find and show the chains of values that led to the value of a parameter or launch argument."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any

from edulaunch.advice.plan.explanation import Entry, entry
from edulaunch.advice.plan.titles import shown_value
from edulaunch.advice.plan.why import Step, argument_chain, name_of, nodes_named, parameter_chain
from edulaunch.engine.nearest import did_you_mean
from edulaunch.errors import UnusableInput

if TYPE_CHECKING:
    from edulaunch.advice.plan.titles import Branch

Declared = Callable[[str, str], Mapping[str, Any]]


def reasons(outline: Branch, name: str, parameter: str | None, declared: Declared) -> list[dict[str, Any]]:
    """Return a dictionary with `name`, `value` and `steps` for each requested value.

    :param outline: the outline of the dry run.
    :param name: the name of a node or of a launch argument.
    :param parameter: the name of the parameter, or None for all parameters.
    :param declared: a function that returns the parameters that a program declares, from its package and its executable.
    :raises UnusableInput: when there is no such node, parameter or argument.
    """
    if parameter is None and not name.startswith('/'):
        return [_reason(f'launch argument {name}', argument_chain(outline, name))]
    return [reason for node in nodes_named(outline, name) for reason in _of_node(node, parameter, declared)]


def _reason(name: str, steps: list[Step]) -> dict[str, Any]:
    return {'name': name, 'value': steps[-1]['value'] if steps else None, 'steps': steps}


def _of_node(node: Branch, parameter: str | None, declared: Declared) -> list[dict[str, Any]]:
    item = node.item
    assert item is not None
    set_names = {one.name for one in node.action.given_parameters()}
    defaults = declared(item['package'], item['executable']) if item['package'] else {}
    if parameter is None:
        names = sorted(set_names)
    elif parameter in set_names or parameter in defaults:
        names = [parameter]
    else:
        known = sorted({*set_names, *defaults})
        help = did_you_mean(parameter, known) or (f'its parameters are {", ".join(known)}' if known else None)
        raise UnusableInput(
            f"'{name_of(node)}' has no parameter '{parameter}': it declares none with this name, and the launch file sets none.",
            help=help,
        )
    return [_reason(f'{name_of(node)}  {one}', parameter_chain(node, one, _default(item, one, defaults))) for one in names]


def _default(item: dict[str, Any], name: str, defaults: Mapping[str, Any]) -> Step | None:
    if name not in defaults:
        return None
    origin = f'declared by {item["executable"]}'
    return {'value': defaults[name], 'origin': origin, 'file': None, 'line': None, 'counts': False, 'argument': []}


def rendered_reasons(data: list[dict[str, Any]]) -> tuple[str, list[Entry]]:
    """Return a title, and the chains as entries. The effective value comes last. A single chain needs no title of its own."""
    found = []
    for reason in data:
        one = entry('why', f'{reason["name"]} = {shown_value(reason["value"])}')
        one['children'] = [_step_entry(step) for step in reason['steps']]
        found.append(one)
    if len(found) == 1:
        return found[0]['text'], found[0]['children']
    return f'{len(found)} values', found


def _step_entry(step: Step) -> Entry:
    counts = '  (this counts)' if step['counts'] else ''
    found = entry('step', f'{shown_value(step["value"])}  {step["origin"]}{counts}', step['file'], step['line'])
    found['children'] = [_step_entry(below) for below in step['argument']]
    return found
