"""Whose interfaces count."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from edulaunch.interfaces import current_registry, running
from edulaunch.interfaces.registry import Registry


@pytest.fixture
def source() -> Iterator[Registry]:
    before = list(running._sources)
    registry = Registry([])
    running.answer_with(lambda: registry)
    yield registry
    running._sources[:] = before


def test_the_running_programs_interfaces_go_first(source: Registry) -> None:
    assert current_registry() is source
    running.answer_with(lambda: None)
    assert current_registry() is not source
