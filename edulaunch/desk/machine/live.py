"""The live machine: one simulation in real time, and what looks at it.

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
"""How long a page is kept up to date after it asked for it."""
FORGET_EVERY_S = 10.0
MESSAGES_KEPT = 200
"""A machine drops old messages every so many simulated seconds, and keeps so many of each topic."""
PATIENCE_S = 15.0
"""Simulated seconds that a program has to end after Ctrl-C."""


class Page:
    """One page that shows the machine: kept up to date for a while after it asked."""

    def __init__(self, viewer: Viewer) -> None:
        self.viewer = viewer
        self._until_s = self._next_s = 0.0

    def ask(self) -> None:
        """The page asks what is new."""
        self._until_s = time.monotonic() + SHOWN_FOR_S

    def is_shown(self) -> bool:
        """Whether a user looks at it."""
        return time.monotonic() < self._until_s

    def show(self) -> None:
        """Send what is new, if it is time to."""
        now_s = time.monotonic()
        if self._next_s <= now_s < self._until_s:
            self._next_s = now_s + SHOWN_EVERY_S
            self.viewer.show()


class LiveMachine(ViewedMachine):
    """Runs a session in real time, shows it on pages, and joins it to a real ROS 2 network.

    :param keep_s: simulated seconds after which messages are dropped, or None to keep all of them.
    :param selector: what the owner's loop waits for; the machine makes one when it first needs it.
    :ivar pages: the pages in a notebook that show it.
    :ivar network: what joins a real network. None until a page or a command asks for it.
    :ivar listeners: called with what its users have to know.
    """

    def __init__(self, keep_s: float | None = None, selector: selectors.BaseSelector | None = None) -> None:
        self.keep_s = keep_s
        self.selector = selector
        self.pages: list[Page] = []
        self.network: Network | None = None
        self.listeners: list[Callable[[str], object]] = []
        self._forgot_s = 0.0

    def use(self, session: Session, speed: float = 1.0) -> None:
        """Run this session from now on. The session before is its owner's to close."""
        self.leave_network()
        self.network = None
        self.listeners = []
        self.session = session
        session.steps_launches = self.steps_launches
        self.time = RealTime(session.sim, speed)
        self._forgot_s = session.sim.elapsed_s

    def run_due(self) -> float | None:
        """Run what is due. Returns the seconds until the next item is due, or None without one."""
        wait_s = self.time.advance()
        if self.network is not None:
            self.network.after_turn()
        self.forget()
        return wait_s

    def forget(self) -> None:
        """Drop old messages now and then, so that a machine that runs for hours stays small."""
        sim = self.session.sim
        if self.keep_s is not None and sim.elapsed_s - self._forgot_s >= FORGET_EVERY_S:
            self._forgot_s = sim.elapsed_s
            self.session.host.forget_overlays()
            self.session.recorder.forget_before(sim.now_ns - round(self.keep_s * 1e9), MESSAGES_KEPT)

    def show_pages(self) -> None:
        """Send each page what is new."""
        for page in list(self.pages):
            page.show()

    # -- what its pages ask for

    def soon(self, action: Callable[[], object]) -> None:
        """Do something where the machine runs; from any thread."""
        raise NotImplementedError

    def do_for(self, viewer: Viewer, request: dict[str, Any]) -> None:
        """What the page of a viewer asks for."""
        with in_its_turn():
            viewer.take(request)

    # -- the real network

    def tell(self, text: str) -> None:
        """What its users have to know, also for the record."""
        self.session.recorder.note(None, 'network', text)
        for listener in self.listeners:
            listener(text)

    def switch(self) -> Network:
        """What joins this machine to a real network; loaded when first asked for.

        :raises UnusableInput: when no plug-in brings it.
        """
        if self.network is None:
            service = network_service()
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
        return self.has_joined if self.network is not None or can_join_network() else None

    def join_network(self, joins: bool) -> str:
        """What the button of a page does, in the environment in which the machine was started."""
        printed: list[str] = []
        self.switch().run(['on' if joins else 'off'], os.environ, printed.append, self.tell)
        return ''.join(printed).strip()

    def leave_network(self) -> None:
        """Leave the real network, if it has joined one."""
        if self.network is not None:
            self.network.off()


@contextmanager
def in_its_turn() -> Iterator[None]:
    """Use it around each turn of a machine that lives in the asyncio loop of a notebook."""
    with outer_loop_set_aside(), streams_of_programs():
        yield


def finish(
    session: Session, process: Process, seconds: float, on_late: Callable[[bool], object] = lambda interrupted: None
) -> None:
    """Run until a command has ended. After `seconds` press Ctrl-C, and kill it when it does not end by that.

    The command's `on_exit` has to stop the simulation.

    :param on_late: called before Ctrl-C is pressed; True when the user has interrupted the run.
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
