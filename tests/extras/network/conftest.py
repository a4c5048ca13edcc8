"""Machines side by side."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

import pytest

from tests.extras.network.places import Air, MemoryLink, Place
from tests.extras.network.wires import Wire, own_domain

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


@pytest.fixture
def domain() -> Iterator[int]:
    """A domain that nobody else on this computer has."""
    pytest.importorskip('cyclonedds', reason="cyclonedds is not installed: pip install '.[network]'")
    with own_domain() as number:
        yield number


@pytest.fixture
def wire(domain: int) -> Iterator[Wire]:
    """Who is on one domain of the loopback."""
    made = Wire(domain)
    yield made
    made.close()
