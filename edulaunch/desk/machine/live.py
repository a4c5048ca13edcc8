"""The live machine: one simulation in real time, and its pages.

A notebook's cells, a machine that `edulaunch.start` made, and the process that terminals share all run this machine. They differ
in the loop that gives it its turns: `jupyter/hosting.py`, `started.py` and `serving.py`.
"""

from __future__ import annotations

import os
import selectors
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from typing import Any

from edulaunch.desk.machine.network import Network, can_join_network, network_service
from edulaunch.desk.view import ViewedMachine
from edulaunch.desk.view.viewer import Viewer
from edulaunch.engine.processes.process import Process
from edulaunch.engine.processes.spec import Signals
from edulaunch.engine.processes.streams import streams_of_programs
from edulaunch.engine.sim.loops import outer_loop_set_aside
from edulaunch.engine.sim.pacing import RealTime
from edulaunch.errors import UnusableInput
from edulaunch.runtime import plugins
from edulaunch.runtime.session import Session

SHOWN_EVERY_S = 1 / 30
SHOWN_FOR_S = 1.5
"""A page receives updates for this long after it asked for them."""
FORGET_EVERY_S = 10.0
MESSAGES_KEPT = 200
"""A machine drops old messages after each period of this many simulated seconds, and keeps some of each topic."""
PATIENCE_S = 15.0
"""A program has this many simulated seconds to end after Ctrl-C."""


class Page:
    """One page that shows the machine; it receives updates for a while after each request."""

    def __init__(self, viewer: Viewer) -> None:
        self.viewer = viewer
        self._until_s = self._next_s = 0.0

    def ask(self) -> None:
        """Record that the page asks for news."""
        self._until_s = time.monotonic() + SHOWN_FOR_S

    def is_shown(self) -> bool:
        """Return whether a user looks at it."""
        return time.monotonic() < self._until_s

    def show(self) -> None:
        """Send the news if they are due."""
        now_s = time.monotonic()
        if self._next_s <= now_s < self._until_s:
            self._next_s = now_s + SHOWN_EVERY_S
            self.viewer.show()


class LiveMachine(ViewedMachine):
    """Runs a session in real time, shows it on pages, and joins it to a real ROS 2 network.

    :param keep_s: simulated seconds after which messages are dropped, or None to keep all of them.
    :param selector: the owner's loop waits on it; the machine creates one when it first needs it.
    :ivar pages: the pages in a notebook that show the machine.
    :ivar network: the connection to a real network. None until a page or a command asks for it.
    :ivar listeners: called with messages for the users.
    """

    def __init__(self, keep_s: float | None = None, selector: selectors.BaseSelector | None = None) -> None:
        self.keep_s = keep_s
        self.selector = selector
        self.pages: list[Page] = []
        self.network: Network | None = None
        self.listeners: list[Callable[[str], object]] = []
        self._forgot_s = 0.0

    def use(self, session: Session, speed: float = 1.0) -> None:
        """Run this session from now on. The owner closes the previous session."""
        self.leave_network()
        self.network = None
        self.listeners = []
        self.session = session
        session.steps_launches = self.steps_launches
        self.time = RealTime(session.sim, speed)
        self._forgot_s = session.sim.elapsed_s

    def run_due(self) -> float | None:
        """Run the due items. Return the seconds until the next item is due, or None without one."""
        wait_s = self.time.advance()
        if self.network is not None:
            self.network.after_turn()
        self.forget()
        return wait_s

    def forget(self) -> None:
        """Drop old messages from time to time, so that a machine that runs for hours stays small."""
        sim = self.session.sim
        if self.keep_s is not None and sim.elapsed_s - self._forgot_s >= FORGET_EVERY_S:
            self._forgot_s = sim.elapsed_s
            self.session.host.forget_overlays()
            self.session.recorder.forget_before(sim.now_ns - round(self.keep_s * 1e9), MESSAGES_KEPT)

    def show_pages(self) -> None:
        """Send the news to each page."""
        for page in list(self.pages):
            page.show()

    # -- requests of its pages

    def soon(self, action: Callable[[], object]) -> None:
        """Run a function on the machine's thread; callable from any thread."""
        raise NotImplementedError

    def do_for(self, viewer: Viewer, request: dict[str, Any]) -> None:
        """Handle a request from the page of a viewer."""
        with in_its_turn():
            viewer.take(request)

    # -- the real network

    def tell(self, text: str) -> None:
        """Show a message to the users, and record it."""
        self.session.recorder.note(None, 'network', text)
        for listener in self.listeners:
            listener(text)

    def switch(self) -> Network:
        """Return the connection to a real network, which is loaded at the first request.

        :raises UnusableInput: when no plug-in provides it.
        """
        if self.network is None:
            service = network_service()
            if service is None:
                raise plugins.absent('edulaunch network') or UnusableInput('no plug-in provides a network')
            self.selector = self.selector or selectors.DefaultSelector()
            network: Network = service.make(self.session, self.time, self.selector)
            self.network = network
        return self.network

    @property
    def has_joined(self) -> bool:
        """Return whether it is on a real network now."""
        return self.network is not None and self.network.is_on

    @property
    def is_on_network(self) -> bool | None:
        """Return whether it has joined a real network; None if Cyclone DDS is not installed."""
        return self.has_joined if self.network is not None or can_join_network() else None

    def join_network(self, joins: bool) -> str:
        """Handle a page's button for the network, in the environment in which the machine was started."""
        printed: list[str] = []
        self.switch().run(['on' if joins else 'off'], os.environ, printed.append, self.tell)
        return ''.join(printed).strip()

    def leave_network(self) -> None:
        """Leave the real network, if it has joined one."""
        if self.network is not None:
            self.network.off()


@contextmanager
def in_its_turn() -> Iterator[None]:
    """Return a context for each turn of a machine in the asyncio loop of a notebook."""
    with outer_loop_set_aside(), streams_of_programs():
        yield


def finish(
    session: Session, process: Process, seconds: float, on_late: Callable[[bool], object] = lambda interrupted: None
) -> None:
    """Run until a command has ended. After `seconds`, press Ctrl-C, and kill the command if that does not end it.

    The command's `on_exit` must stop the simulation.

    :param on_late: called before Ctrl-C is pressed; returns True if the user has interrupted the run.
    """
    interrupted = session.run(seconds)
    if process.returncode is None:
        on_late(interrupted)
        process.send_signal(Signals.SIGINT)
        session.run(PATIENCE_S)
    if process.returncode is None:
        process.send_signal(Signals.SIGKILL)


def end_programs(session: Session, programs: Sequence[Process]) -> None:
    """Press Ctrl-C for some programs, give them :data:`PATIENCE_S` of simulated time to end, and kill the rest."""
    left = [program for program in programs if program.returncode is None]
    for program in left:
        program.send_signal(Signals.SIGINT)
    latest_ns = session.sim.now_ns + round(PATIENCE_S * 1e9)
    while any(program.returncode is None for program in left) and session.sim.now_ns < latest_ns:
        session.run(0.1)
    for program in left:
        program.send_signal(Signals.SIGKILL)
    session.run(0.0)
