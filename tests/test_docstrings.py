"""Functions that people call from notebooks and scripts explain each of their parameters.

`docs/public_api.md` lists the public names. Functions of the engine that compute with transforms
and robots count, too: their shapes, units and frames are easy to confuse.
"""

from __future__ import annotations

import importlib
import inspect
import re
from collections.abc import Iterator
from types import FunctionType
from typing import Any

import pytest

import edulaunch

WINGS = ('edulaunch.canvas', 'edulaunch.course')
COMPUTING = (
    'tf.buffer',
    'tf.quaternions',
    'tf.transforms',
    'tf.velocity',
    'worlds.planar_robot',
    'worlds.turtle',
    'worlds.turtle_world',
)
RETURNS_ONLY = {'self', 'cls'}


def public() -> Iterator[tuple[str, FunctionType]]:
    """Yield the public functions and methods with their names."""
    for name in edulaunch.__all__:
        yield from functions(f'edulaunch.{name}', getattr(edulaunch, name))
    for wing in WINGS:
        module = importlib.import_module(wing)
        for name in module.__all__:
            yield from functions(f'{wing}.{name}', getattr(module, name))
    for name in COMPUTING:
        module = importlib.import_module(f'edulaunch.engine.{name}')
        for known, thing in vars(module).items():
            if not known.startswith('_') and getattr(thing, '__module__', '') == module.__name__:
                yield from functions(f'engine.{name}.{known}', thing)


def functions(name: str, thing: Any) -> Iterator[tuple[str, FunctionType]]:
    """Yield a function, or the public methods that a class and its bases in edulaunch define."""
    if isinstance(thing, FunctionType):
        yield name, thing
    elif isinstance(thing, type):
        for owner in thing.__mro__:
            if owner.__module__.startswith('edulaunch'):
                for method, function in vars(owner).items():
                    if isinstance(function, FunctionType) and not method.startswith('_'):
                        yield f'{name}.{method}', function


def unexplained(function: FunctionType) -> list[str]:
    """Return the parameters that neither a field nor a name in backquotes of the docstring explains."""
    text = inspect.getdoc(function) or ''
    fields = {name.strip('* ') for names in re.findall(r'^:param ([^:]*):', text, re.M) for name in names.split(',')}
    code = set(re.findall(r'\w+', ' '.join(re.findall(r'`([^`]*)`', text))))
    return [name for name in inspect.signature(function).parameters if name not in fields | code | RETURNS_ONLY]


@pytest.mark.parametrize(('name', 'function'), [pytest.param(*pair, id=pair[0]) for pair in public()])
def test_each_parameter_is_explained(name: str, function: FunctionType) -> None:
    assert unexplained(function) == [], f'explain them in the docstring of {name}'


def test_an_unexplained_parameter_is_found() -> None:
    def turn(angle: float, axis: str, speed: float) -> None:
        """Turn around `axis`.

        :param angle: radians, counter-clockwise.
        """

    assert unexplained(turn) == ['speed']
