"""The network of one machine, switched on and off: what `edulaunch network` and `ros2 launch --network` do."""

from __future__ import annotations

import argparse
import selectors
import time as wall
from collections.abc import Callable, Mapping, Sequence

from edulaunch.network.bridge import Bridge
from edulaunch.network.link import LinkError, Settings
from edulaunch.network.links import DEFAULT, make_link
from edulaunch.network.settings import chooser, settings_of
from edulaunch.session import Session
from edulaunch.sim.pacing import RealTime

FARTHEST_NS = 24 * 3600 * 10**9
"""A clock that is further from the wall's cannot be set: what was recorded until now would be that far away."""
WIDE = {'LOCALHOST': 'this computer alone', 'SUBNET': 'the whole subnet', 'OFF': 'nobody (OFF)'}


class Switch:
    """Joins a machine to the network, and lets it leave.

    :param selector: what the machine waits with.
    """

    def __init__(self, session: Session, time: RealTime, selector: selectors.BaseSelector) -> None:
        self._session, self._time, self._selector = session, time, selector
        self.bridge: Bridge | None = None
        self._settings = Settings()
        self._topics: Sequence[str] = ()

    def on(self, env: Mapping[str, str], topics: Sequence[str], link: str, tell: Callable[[str], object]) -> None:
        """Join; an earlier bridge leaves before.

        :raises LinkError: when that cannot be.
        """
        settings = settings_of(env)
        made = make_link(link)
        self.off()
        if not -(10**9) < wall.time_ns() - self._session.sim.now_ns < FARTHEST_NS:
            raise LinkError("this machine's clock is not that of the wall", help='edulaunch machine stop, and begin anew')
        bridge = Bridge(self._session, made, chooser(topics), tell)
        self._time.is_wall = True
        try:
            bridge.open(settings)
        except LinkError:
            self._time.is_wall = False
            raise
        self._selector.register(made.fileno(), selectors.EVENT_READ, lambda events: bridge.take())
        self.bridge, self._settings, self._topics = bridge, settings, topics

    def off(self) -> bool:
        """Leave; whether it was on."""
        bridge, self.bridge = self.bridge, None
        if bridge is None:
            return False
        self._selector.unregister(bridge.link.fileno())
        bridge.close()
        self._time.is_wall = False
        return True

    def join(
        self, env: Mapping[str, str], topics: Sequence[str], link: str, tell: Callable[[str], object]
    ) -> Callable[[], object]:
        """Join for as long as a program runs; returns what to call at its end. Who has joined already stays as it is.

        :raises LinkError: when that cannot be.
        """
        if self.bridge is not None:
            return lambda: None
        self.on(env, topics, link, tell)
        joined = self.bridge
        return lambda: self.off() if self.bridge is joined else None

    def after_turn(self) -> None:
        """Called after each turn of the machine."""
        if self.bridge is not None:
            self.bridge.after_turn()

    def status(self) -> str:
        """What crosses, in words."""
        bridge = self.bridge
        if bridge is None:
            return 'the network is off\n'
        settings, far = self._settings, bridge.link.graph()
        peers = f' and {", ".join(settings.static_peers)}' if settings.static_peers else ''
        lines = [
            f'network: domain {settings.domain} of {WIDE[settings.discovery_range]}{peers}, by {bridge.link.title}',
            f'crossing: {" ".join(self._topics) or "all topics"}; {bridge.sent} messages sent, {bridge.heard} heard',
            f'real nodes: {len(far.nodes)}, with {len(far.endpoints)} endpoints',
            *(f'  {"" if node.namespace == "/" else node.namespace}/{node.name}' for node in far.nodes),
            *(f'warning: {line}' for line in bridge.troubles.lines()),
        ]
        return '\n'.join(lines) + '\n'


def run_network(
    switch: Switch, words: Sequence[str], env: Mapping[str, str], say: Callable[[str], object], tell: Callable[[str], object]
) -> int:
    """`edulaunch network on|off|status`; returns the exit code."""
    word = words[0] if words else 'status'
    if word == 'off':
        say('the network is off\n' if switch.off() else 'the network was off\n')
    elif word == 'on':
        options = options_of(words[1:])
        try:
            switch.on(env, options.topics, options.link, tell)
        except LinkError as error:
            say(f'error: {error}\n')
            return 1
        say(switch.status())
    else:
        say(switch.status())
    return 0


def options_of(words: Sequence[str]) -> argparse.Namespace:
    """`--topics NAME...` and `--link NAME`."""
    parser = argparse.ArgumentParser()
    parser.add_argument('--topics', nargs='*', default=[])
    parser.add_argument('--link', default=DEFAULT)
    return parser.parse_args(list(words))
