"""A session whose programs are real processes, and whose launch communicates with them."""

from __future__ import annotations

import os
import sys
import time
from typing import Any

from edulaunch.errors import EdulaunchError
from edulaunch.extras.native.host import NativeHost
from edulaunch.extras.network.bridge import Bridge
from edulaunch.extras.network.links import make_link
from edulaunch.extras.network.settings import settings_of
from edulaunch.runtime.session import Session

LOOK_EVERY_NS = 10_000_000


class NativeSession(Session):
    """A session whose programs are real processes. Its clock shows the time of day.

    The processes find each other on this computer only, unless ROS_AUTOMATIC_DISCOVERY_RANGE allows more. To
    load components or to change lifecycle states, launch creates its own node. This node joins the network of the processes
    through the rclpy link.
    """

    host_class = NativeHost

    def __init__(self, **options: Any) -> None:
        env = dict(os.environ if options.get('env') is None else options['env'])
        env.setdefault('ROS_AUTOMATIC_DISCOVERY_RANGE', 'LOCALHOST')
        super().__init__(**{**options, 'env': env, 'start_ns': time.time_ns()})
        self._bridge: Bridge | None = None
        self.graph.on_change.append(self._join)

    def _join(self) -> None:
        if self._bridge is None and self.graph.nodes:
            self._bridge = Bridge(self, make_link('rclpy'), tell=_tell)
            self.sim.schedule(self.sim.now_ns, self._open)

    def _open(self) -> None:
        assert self._bridge is not None
        try:
            self._bridge.open(settings_of(self.host.env))
        except EdulaunchError as error:
            _tell(f'launch cannot reach the nodes, so it cannot load components or change states: {error}')
        else:
            self._look()

    def _look(self) -> None:
        assert self._bridge is not None
        self._bridge.take()
        self._bridge.after_turn()
        self.sim.schedule(self.sim.now_ns + LOOK_EVERY_NS, self._look)

    def close(self) -> None:
        """Implement `Session.close`."""
        if self._bridge is not None:
            self._bridge.close()
        super().close()


def _tell(text: str) -> None:
    print(f'warning: {text}', file=sys.stderr)
