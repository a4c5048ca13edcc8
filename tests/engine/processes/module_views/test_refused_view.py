"""Modules that are refused with a sentence."""

from __future__ import annotations

from typing import Any

import pytest


@pytest.mark.parametrize('name', ['pkg_resources', 'pkgutil'])
def test_what_nobody_needs_is_refused_with_a_sentence(world: Any, name: str) -> None:
    wrote = world.run(f'import {name}')
    assert f"ModuleNotFoundError: No module named '{name}'" in wrote
    assert 'use importlib.resources or ament_index_python' in wrote


def test_turtle_can_be_imported_and_each_name_says_when_it_is_called_that_there_is_no_window(world: Any) -> None:
    wrote = world.run('from turtle import Screen, forward\nimport turtle\nprint(turtle.forward is forward)\nforward(100)')
    assert wrote.startswith('True\n') and 'RuntimeError: no display' in wrote
    assert "module 'turtle' has no attribute '_x'" in world.run('import turtle\nturtle._x')
