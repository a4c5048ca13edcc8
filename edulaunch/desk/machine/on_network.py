"""A machine that can join a real ROS 2 network: what the button of its pages, and commands, ask for.

The network is a service that a plug-in brings; this file says what the machine asks of it.
"""

from __future__ import annotations

import os
import selectors
import time as wall
from collections.abc import Callable, Mapping, Sequence
from functools import cache
from typing import Any, Protocol

from edulaunch.desk.view import Living
from edulaunch.errors import UnusableInput
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
        self,
        env: Mapping[str, str],
        link: str,
        clock: bool,
        topics: Sequence[str],
        tell: Callable[[str], object],
        say: Callable[[str], object],
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
def _service() -> Any | None:
    return plugins.service('network')


@cache
def _can_join() -> bool:
    service = _service()
    return service is not None and service.is_available()


class OnNetwork(Living):
    """A machine whose time can be that of the clock on the wall.

    :ivar network: what has joined it, once it was asked for.
    :ivar selector: what is waited for; one of its own is made when it is first needed.
    """

    network: Network | None = None
    selector: selectors.BaseSelector | None = None

    def tell(self, text: str) -> None:
        """What whoever uses it has to know, also for the record."""
        self.session.recorder.note(None, 'network', text)

    def switch(self) -> Network:
        """What joins this machine to a real network; loaded when first asked for.

        :raises UnusableInput: when no plug-in brings it.
        """
        if self.network is None:
            service = _service()
            if service is None:
                raise plugins.absent('edulaunch network') or UnusableInput('no plug-in brings a network')
            self.selector = self.selector or selectors.DefaultSelector()
            network: Network = service.make(self.session, self.time, self.selector)
            self.network = network
        return self.network

    @property
    def has_joined(self) -> bool:
        """Whether it is on a real network now."""
        return self.network is not None and self.network.is_on

    @property
    def is_on_network(self) -> bool | None:
        """Whether it has joined a real network; None where Cyclone DDS is not installed."""
        return self.has_joined if self.network is not None or _can_join() else None

    def join_network(self, joins: bool) -> str:
        """What the button of a page does, in the environment in which the machine was started."""
        said: list[str] = []
        self.switch().run(['on' if joins else 'off'], os.environ, said.append, self.tell)
        return ''.join(said).strip()
