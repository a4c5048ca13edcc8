"""Participants of the loopback, each test in a domain that nobody else on this computer has."""

from __future__ import annotations

import fcntl
import select
import tempfile
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import pytest

from edulaunch.extras.network.network_link import Settings
from tests.extras.network.places import Place

DOMAINS = range(69, 29, -1)
"""Those above are taken by `edulaunch compare`."""
LIMIT_S = 120.0
"""When a condition has not come true by then it never will; nothing is measured by it."""


@contextmanager
def own_domain() -> Iterator[int]:
    """A number of a domain, kept by a lock until the test is over."""
    place = Path(tempfile.gettempdir()) / 'edulaunch-test-domains'
    place.mkdir(exist_ok=True)
    for number in DOMAINS:
        with open(place / str(number), 'w') as file:
            try:
                fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
            except BlockingIOError:
                continue
            yield number
            return
    pytest.skip('no domain is free')


class Wire:
    """What is on one domain of the loopback, and time that passes for all of it."""

    def __init__(self, domain: int) -> None:
        self.settings = Settings(domain)
        self.places: list[Place] = []
        self.links: list[Any] = []

    def link(self) -> Any:
        """Somebody who is no machine of ours, joined already."""
        from edulaunch.extras.network.dds.link import CycloneLink

        self.links.append(CycloneLink())
        self.links[-1].open(self.settings)
        return self.links[-1]

    def place(self, name: str = 'node', **options: Any) -> Place:
        """A machine with a bridge."""
        from edulaunch.extras.network.dds.link import CycloneLink

        self.places.append(Place(CycloneLink(), self.settings, name, **options))
        return self.places[-1]

    def until(self, condition: Callable[[], object], each: Callable[[], object] = lambda: None) -> None:
        """Let time pass until something is so; `each` is called in each turn."""
        end_s = time.monotonic() + LIMIT_S
        while not condition():
            assert time.monotonic() < end_s, 'it never came'
            select.select([*(place.link for place in self.places), *self.links], [], [], 0.01)
            for place in self.places:
                if not place.time.is_wall:
                    place.time.is_wall = True
                place.time.advance()
                place.turn()
            for link in self.links:
                link.flush()
            each()

    def close(self) -> None:
        for place in self.places:
            place.close()
        for link in self.links:
            link.close()
