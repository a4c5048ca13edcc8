"""The interface between a live machine and a real ROS 2 network. A plug-in provides the network as a service."""

from __future__ import annotations

import time as wall
from collections.abc import Callable, Mapping, Sequence
from functools import cache
from typing import Any, Protocol

from edulaunch.runtime import plugins

FARTHEST_NS = 24 * 3600 * 10**9
"""The largest difference from real time, in nanoseconds, with which a machine can join. Its recording would contain this gap."""


def is_walls_time(now_ns: int) -> bool:
    """Return whether a machine's time (in nanoseconds) is close to real time."""
    return -(10**9) < wall.time_ns() - now_ns < FARTHEST_NS


class Network(Protocol):
    """The connection of a machine to a real network.

    A plug-in provides a module as the service 'network'. The function `is_available()` of this module returns whether the
    service can be used, and `make(session, time, selector)` returns such a connection.
    """

    @property
    def is_on(self) -> bool:
        """Return whether the machine has joined the network."""

    def run(
        self, words: Sequence[str], env: Mapping[str, str], say: Callable[[str], object], tell: Callable[[str], object]
    ) -> int:
        """Run `edulaunch network WORDS...`. Return the exit code.

        :param words: the words of the command.
        :param env: the environment of the command.
        :param say: a function that writes to the terminal of the command.
        :param tell: a function that writes to all terminals.
        """

    def join(
        self, env: Mapping[str, str], words: Sequence[str], tell: Callable[[str], object], say: Callable[[str], object]
    ) -> Callable[[], object]:
        """Join the network while a program runs. Return a function to call when the program has ended."""

    def where(self) -> str:
        """Return a description of the network and of the library that connects to it."""

    def listen(self, seconds: float) -> None:
        """Wait at most `seconds` for data of the network, and handle the data that have arrived."""

    def after_turn(self) -> None:
        """Do the work that is due after the machine has run. The machine calls this method."""

    def off(self) -> bool:
        """Leave the network. Return whether the machine was connected to it."""


@cache
def network_service() -> Any | None:
    """Return the module of the network service, or None if no plug-in provides it."""
    return plugins.service('network')


@cache
def can_join_network() -> bool:
    """Return whether the network service and the library that it needs are installed."""
    service = network_service()
    return service is not None and service.is_available()
