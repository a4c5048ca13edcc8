"""What a live machine asks of a real ROS 2 network. A plug-in brings the network as a service."""

from __future__ import annotations

import time as wall
from collections.abc import Callable, Mapping, Sequence
from functools import cache
from typing import Any, Protocol

from edulaunch.runtime import plugins

FARTHEST_NS = 24 * 3600 * 10**9
"""A clock that is further from the wall's cannot be set: what was recorded until now would be that far away."""


def is_walls_time(now_ns: int) -> bool:
    """Whether a machine's time is about that of the clock on the wall."""
    return -(10**9) < wall.time_ns() - now_ns < FARTHEST_NS


class Network(Protocol):
    """The service of the name 'network'. Its module has `is_available()` and `make(session, time, selector)` returns this."""

    @property
    def is_on(self) -> bool:
        """Whether it has joined."""

    def run(
        self, words: Sequence[str], env: Mapping[str, str], say: Callable[[str], object], tell: Callable[[str], object]
    ) -> int:
        """`edulaunch network WORDS...`; returns the exit code.

        :param say: writes to who has asked.
        :param tell: writes to everybody.
        """

    def join(
        self, env: Mapping[str, str], words: Sequence[str], tell: Callable[[str], object], say: Callable[[str], object]
    ) -> Callable[[], object]:
        """Join for as long as a program runs; returns what to call at its end."""

    def where(self) -> str:
        """Which network it is on, and by what."""

    def listen(self, seconds: float) -> None:
        """Take what has come, and wait for it at most so long."""

    def after_turn(self) -> None:
        """Called after each turn of the machine."""

    def off(self) -> bool:
        """Leave; whether it was on."""


@cache
def network_service() -> Any | None:
    """The module of the service; None when no plug-in brings it."""
    return plugins.service('network')


@cache
def can_join_network() -> bool:
    """Whether the service is there, with the library that it needs."""
    service = network_service()
    return service is not None and service.is_available()
