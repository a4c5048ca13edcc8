"""The interface of a live machine to a real ROS 2 network. A plug-in provides the network as a service."""

from __future__ import annotations

import time as wall
from collections.abc import Callable, Mapping, Sequence
from functools import cache
from typing import Any, Protocol

from edulaunch.runtime import plugins

FARTHEST_NS = 24 * 3600 * 10**9
"""If the clock differs from real time by more than this, the machine cannot join: its recording would have such a gap."""


def is_walls_time(now_ns: int) -> bool:
    """Return whether a machine's time is close to real time."""
    return -(10**9) < wall.time_ns() - now_ns < FARTHEST_NS


class Network(Protocol):
    """The service named 'network'. Its module has `is_available()`, and `make(session, time, selector)`, which returns this."""

    @property
    def is_on(self) -> bool:
        """Return whether the machine has joined."""

    def run(
        self, words: Sequence[str], env: Mapping[str, str], say: Callable[[str], object], tell: Callable[[str], object]
    ) -> int:
        """Run `edulaunch network WORDS...`; return the exit code.

        :param say: writes to the terminal of the command.
        :param tell: writes to all terminals.
        """

    def join(
        self, env: Mapping[str, str], words: Sequence[str], tell: Callable[[str], object], say: Callable[[str], object]
    ) -> Callable[[], object]:
        """Join while a program runs; return a function to call at its end."""

    def where(self) -> str:
        """Describe the network and the library that connects to it."""

    def listen(self, seconds: float) -> None:
        """Handle what has arrived, and wait for it at most this long."""

    def after_turn(self) -> None:
        """Called after each turn of the machine."""

    def off(self) -> bool:
        """Leave the network; return whether the machine was on it."""


@cache
def network_service() -> Any | None:
    """Return the module of the service; None if no plug-in provides it."""
    return plugins.service('network')


@cache
def can_join_network() -> bool:
    """Return whether the service and the library that it needs are installed."""
    service = network_service()
    return service is not None and service.is_available()
