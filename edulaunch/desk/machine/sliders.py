"""Sliders in a notebook for the parameters of a live machine. This module is imported late, because it needs ipywidgets."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from edulaunch.engine.nearest import did_you_mean
from edulaunch.errors import MissingExtra, UnusableInput

if TYPE_CHECKING:
    from edulaunch.desk.machine.live import LiveMachine

WITHOUT_STEP = 100
"""The number of steps in a range of floats without a step."""


def slider(
    machine: LiveMachine, take: Callable[[dict[str, Any]], object], node: str, name: str, limits: tuple[float, float] | None
) -> Any:
    """Return a slider that sets a parameter, as in `Machine.slider`.

    :param machine: the machine.
    :param take: a function that handles a request of a live view.
    :param node: the full name of the node.
    :param name: the name of the parameter.
    :param limits: the smallest and the largest value, or None for the range that the node declares.
    """
    ipywidgets = widgets()
    recorder = machine.session.recorder
    known = {row[2]: row[3] for row in recorder.parameters if row[1] == node}
    if not known:
        nodes = {row[1] for row in recorder.parameters}
        raise UnusableInput(f'no node with parameters is named {node!r}', help=did_you_mean(node, nodes) or _names(nodes))
    if known.get(name) is None:
        raise UnusableInput(f'{node} has no parameter {name!r}', help=did_you_mean(name, known) or _names(known))
    value = known[name]
    descriptor = next(
        (row for row in reversed(recorder.descriptors) if row[1:3] == [node, name]), [0, node, name, '', False, None]
    )
    about: dict[str, Any] = {'description': name, 'tooltip': descriptor[3] or f'{node} {name}', 'disabled': descriptor[4]}
    if isinstance(value, bool):
        made = ipywidgets.Checkbox(value=value, **about)
    elif isinstance(value, (int, float)):
        made = _number(ipywidgets, value, descriptor[5], limits, about)
    else:
        raise UnusableInput(f'{node} {name} is not a number: {value!r}', help='change it in machine.view("parameters")')

    def set_parameter(change: Any) -> None:
        text = str(change.new).lower() if isinstance(value, bool) else str(change.new)
        machine.soon(lambda: take({'op': 'param', 'node': node, 'name': name, 'value': text}))

    made.observe(set_parameter, 'value')
    return made


def _number(ipywidgets: Any, value: float, declared: Any, limits: tuple[float, float] | None, about: dict[str, Any]) -> Any:
    """Return a slider over `limits`. Without `limits`, use the declared range.

    :raises UnusableInput: when there is neither a declared range nor `limits`.
    """
    if limits is None and declared is None:
        raise UnusableInput(
            f'{about["description"]} declares no range', help='give a range: machine.slider(node, name, limits=(0, 10))'
        )
    low, high, step = declared if limits is None else (*limits, 0)
    kind, usual = (ipywidgets.IntSlider, 1) if isinstance(value, int) else (ipywidgets.FloatSlider, (high - low) / WITHOUT_STEP)
    return kind(value=value, min=low, max=high, step=step or usual, continuous_update=False, **about)


def widgets() -> Any:
    """Return the module ipywidgets.

    :raises MissingExtra: when ipywidgets is not installed.
    """
    try:
        import ipywidgets
    except ImportError:
        raise MissingExtra('a slider', 'ipywidgets', 'notebook') from None
    return ipywidgets


def _names(names: Any) -> str:
    return f'choose one of: {", ".join(sorted(names))}' if names else 'let some time pass first: machine.run(1)'
