"""The network of one machine, which `edulaunch network` and `ros2 launch --network` switch on and off."""

from __future__ import annotations

import selectors
import sys
import traceback
from collections.abc import Callable, Mapping, Sequence

from edulaunch.desk.machine.network import is_walls_time
from edulaunch.engine.sim.pacing import RealTime
from edulaunch.errors import EdulaunchError, UnusableInput
from edulaunch.extras.network.bridge import Bridge
from edulaunch.extras.network.clock import ClockNode
from edulaunch.extras.network.crossing import JoinRequest, join_request
from edulaunch.extras.network.links import make_link
from edulaunch.extras.network.network_link import LinkError, Settings
from edulaunch.extras.network.settings import nobody_found, settings_of
from edulaunch.runtime.session import Session

MOST_MISTAKES = 20
LONGEST_WAIT_S = 0.01
SETTLED_NS = 3 * 10**9
"""The time after joining in which the machine finds the other nodes."""
ALONE_NS = 10 * 10**9
"""The time without other nodes after which the doctor reports that, too."""
WIDE = {'LOCALHOST': 'this computer alone', 'SUBNET': 'the whole subnet', 'OFF': 'nobody (OFF)'}


class Switch:
    """Joins a machine to the network, and disconnects it.

    :param selector: the selector on which the machine waits.
    """

    def __init__(self, session: Session, time: RealTime, selector: selectors.BaseSelector) -> None:
        self._session, self._time, self._selector = session, time, selector
        self.bridge: Bridge | None = None
        self._settings = Settings()
        self._request = JoinRequest()
        self._clock: ClockNode | None = None
        self._mistakes = 0
        self._joined_ns = 0
        self._tell: Callable[[str], object] = print

    @property
    def is_on(self) -> bool:
        """Return whether the machine has joined a network."""
        return self.bridge is not None

    def on(self, env: Mapping[str, str], request: JoinRequest, tell: Callable[[str], object]) -> None:
        """Join the network. If the machine has already joined, close the earlier bridge first.

        :raises EdulaunchError: when the machine cannot join.
        """
        settings = settings_of(env)
        if not is_walls_time(self._session.sim.now_ns):
            raise LinkError('this machine does not run in real time', help='type edulaunch machine stop, and start again')
        made = make_link(request.link)
        self.off()
        bridge = Bridge(self._session, made, request.crossing, tell)
        self._time.is_wall = True
        self._session.follow = self.follow
        try:
            bridge.open(settings)
        except EdulaunchError:
            self._no_more()
            made.close()
            raise
        self._selector.register(made.fileno(), selectors.EVENT_READ, lambda events: self._safely(bridge.take))
        self.bridge, self._settings, self._request, self._mistakes, self._tell = bridge, settings, request, 0, tell
        self._clock = ClockNode(self._session.graph) if request.clock else None
        self._joined_ns = self._session.sim.now_ns
        self._session.sim.schedule(self._joined_ns + ALONE_NS, lambda: self._note_alone(bridge))

    def _note_alone(self, bridge: Bridge) -> None:
        if self.bridge is bridge and not bridge.link.graph().nodes:
            bridge.note(f'alone {self._settings.domain} {self._settings.discovery_range}')

    def _safely(self, act: Callable[[], object]) -> None:
        """Handle an error of edulaunch without ending the machine: log it, and switch the network off after several errors."""
        try:
            act()
        except Exception:
            traceback.print_exc(file=sys.__stderr__)
            self._mistakes += 1
            if self._mistakes >= MOST_MISTAKES:
                self.off()
                self._tell('the network is off, because edulaunch failed on messages from it; see the log of the machine')

    def off(self) -> bool:
        """Leave the network. Return whether the network was on."""
        bridge, self.bridge = self.bridge, None
        if bridge is None:
            return False
        if self._clock is not None:
            self._clock.stop()
        self._selector.unregister(bridge.link.fileno())
        bridge.close()
        self._no_more()
        return True

    def _no_more(self) -> None:
        self._time.is_wall, self._session.follow = False, None

    def follow(self, until_ns: int | None, is_over: Callable[[], bool]) -> None:
        """Run the simulation in step with real time, as :meth:`Simulation.run` does."""
        sim, wait_s = self._session.sim, 0.0
        while self.bridge is not None and not is_over():
            self.listen(wait_s)
            due_s = self._time.advance()
            self.after_turn()
            if sim.was_stopped or (until_ns is not None and sim.now_ns >= until_ns):
                break
            wait_s = LONGEST_WAIT_S if due_s is None else min(due_s, LONGEST_WAIT_S)

    def join(
        self, env: Mapping[str, str], words: Sequence[str], tell: Callable[[str], object], say: Callable[[str], object]
    ) -> Callable[[], object]:
        """Join while a program runs. Return a function to call when the program ends. A machine that has already joined does not
        change.

        :param words: the options of `edulaunch network on`.
        :param say: called with a description of the network after joining, and again after leaving.
        :raises EdulaunchError: when the machine cannot join.
        """
        request = join_request(words)
        if self.bridge is not None:
            is_same = (settings_of(env), request) == (self._settings, self._request)
            other = '' if is_same else ', with other settings than requested here (type edulaunch network off, and launch again)'
            say(f'this machine is already on the real ROS 2 network{other}: {self.where()}')
            return lambda: None
        self.on(env, request, tell)
        joined = self.bridge
        say(f'joined the real ROS 2 network: {self.where()}')

        def leave() -> None:
            if self.bridge is joined:
                self.off()
                say('left the real ROS 2 network')

        return leave

    def listen(self, seconds: float) -> None:
        """Wait for data from the network for at most `seconds`, and handle them."""
        for key, events in self._selector.select(seconds):
            key.data(events)

    def after_turn(self) -> None:
        """Send changes to the network. The machine calls this method after each turn."""
        if self.bridge is not None:
            self._safely(self.bridge.after_turn)

    def where(self) -> str:
        """Return a description of the network and the link."""
        assert self.bridge is not None
        settings = self._settings
        peers = f' and {", ".join(settings.static_peers)}' if settings.static_peers else ''
        return f'domain {settings.domain} of {WIDE[settings.discovery_range]}{peers}, by {self.bridge.link.title}'

    def status(self) -> str:
        """Return the lines for `edulaunch network status`."""
        bridge = self.bridge
        if bridge is None:
            return 'the network is off\n'
        remote = bridge.link.graph()
        simulated = sum(node.is_simulated for node in remote.nodes)
        others = f' and {simulated} simulated by other machines' if simulated else ''
        lines = [
            f'network: {self.where()}',
            f'crossing: {self._request.crossing}; {bridge.sent} messages sent, {bridge.received} heard',
            f'real nodes: {len(remote.nodes) - simulated}{others}, with {len(remote.endpoints)} endpoints',
            *(
                f'  {node.namespace.rstrip("/")}/{node.name}{" (simulated)" if node.is_simulated else ""}'
                for node in remote.nodes
            ),
            *(f'warning: {line}' for line in bridge.diagnostics.lines()),
        ]
        if not remote.nodes and self._session.sim.now_ns > self._joined_ns + SETTLED_NS:
            lines.append(f'help: {nobody_found(self._settings)}')
        return '\n'.join(lines) + '\n'

    def run(
        self, words: Sequence[str], env: Mapping[str, str], say: Callable[[str], object], tell: Callable[[str], object]
    ) -> int:
        """Run `edulaunch network on OPTIONS...`, `off` or `status`, and return the exit code."""
        word = words[0] if words else 'status'
        if word == 'off':
            say('the network is off\n' if self.off() else 'the network was off\n')
            return 0
        if word == 'on':
            try:
                self.on(env, join_request(words[1:]), tell)
            except EdulaunchError as error:
                say(f'error: {error}\n')
                return 2 if isinstance(error, UnusableInput) else 1
        say(self.status())
        return 0
