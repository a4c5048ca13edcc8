"""A machine that can join a real ROS 2 network: what the button of its pages, and commands, ask for."""

from __future__ import annotations

import os
import selectors
from functools import cache
from importlib.util import find_spec
from typing import TYPE_CHECKING

from edulaunch.desk.view import Living

if TYPE_CHECKING:
    from edulaunch.extras.network.switch import Switch


@cache
def _can_join() -> bool:
    return find_spec('cyclonedds') is not None


class OnNetwork(Living):
    """A machine whose time can be that of the clock on the wall.

    :ivar network: what has joined it, once it was asked for.
    :ivar selector: what is waited for; one of its own is made when it is first needed.
    """

    network: Switch | None = None
    selector: selectors.BaseSelector | None = None

    def tell(self, text: str) -> None:
        """What whoever uses it has to know, also for the record."""
        self.session.recorder.note(None, 'network', text)

    def switch(self) -> Switch:
        """What joins this machine to a real network; loaded when first asked for."""
        if self.network is None:
            from edulaunch.extras.network.switch import Switch

            self.selector = self.selector or selectors.DefaultSelector()
            self.network = Switch(self.session, self.time, self.selector)
        return self.network

    @property
    def is_on_network(self) -> bool | None:
        """Whether it has joined a real network; None where Cyclone DDS is not installed."""
        if self.network is None:
            return False if _can_join() else None
        return self.network.bridge is not None

    def join_network(self, joins: bool) -> str:
        """What the button of a page does, in the environment in which the machine was started."""
        from edulaunch.extras.network.switch import run_network

        said: list[str] = []
        run_network(self.switch(), ['on' if joins else 'off'], os.environ, said.append, self.tell)
        return ''.join(said).strip()
