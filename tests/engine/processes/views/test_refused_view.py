"""Modules that are refused with a sentence."""

from __future__ import annotations

from typing import Any

import pytest


@pytest.mark.parametrize('name', ['pkg_resources', 'pkgutil'])
def test_what_nobody_needs_is_refused_with_a_sentence(world: Any, name: str) -> None:
    wrote = world.run(f'import {name}')
    assert f"ModuleNotFoundError: No module named '{name}'" in wrote
    assert 'use importlib.resources or ament_index_python' in wrote
