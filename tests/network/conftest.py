"""Machines side by side."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

import pytest

from tests.network.places import Air, MemoryLink, Place

Places = Callable[..., Place]


@pytest.fixture
def air() -> Air:
    """A network in memory."""
    return Air()


@pytest.fixture
def place(air: Air) -> Iterator[Places]:
    """Makes machines on that network; all leave it at the end."""
    made: list[Place] = []

    def make(name: str = 'node', **options: Any) -> Place:
        made.append(Place(MemoryLink(air), name=name, **options))
        return made[-1]

    yield make
    for each in made:
        each.close()
