"""The live machine: one simulation in real time, and the pages that show it.

Three owners run such a machine: the cells of a notebook, a machine of `edulaunch.start`, and the process that terminals
share. The owners differ in the loop that calls the machine: `notebook/hosting.py`, `started.py` and `serving.py`.
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
    """One page that shows the machine. It receives updates for a while after each request."""

    def __init__(self, viewer: Viewer) -> None:
        self.viewer = viewer
        self._until_s = self._next_s = 0.0

    def ask(self) -> None:
        """Record that the page has requested updates."""
        self._until_s = time.monotonic() + SHOWN_FOR_S

    def is_shown(self) -> bool:
        """Return whether the page is visible, because it has requested updates recently."""
        return time.monotonic() < self._until_s

    def show(self) -> None:
        """Send an update if one is due."""
        now_s = time.monotonic()
        if self._next_s <= now_s < self._until_s:
            self._next_s = now_s + SHOWN_EVERY_S
            self.viewer.show()


class LiveMachine(ViewedMachine):
    """Runs a session in real time, shows it on pages, and connects it to a real ROS 2 network.

    :param keep_s: the simulated time in seconds after which messages are dropped, or None to keep all messages.
    :param selector: the selector on which the owner's loop waits. If None, the machine creates one when it needs it.
    :ivar pages: the pages in a notebook that show the machine.
    :ivar network: the connection to a real network, or None until a page or a command requests the connection.
    :ivar listeners: functions that are called with each message for the users.
    """

    def __init__(self, keep_s: float | None = None, selector: selectors.BaseSelector | None = None) -> None:
        self.keep_s = keep_s
        self.selector = selector
        self.pages: list[Page] = []
        self.network: Network | None = None
        self.listeners: list[Callable[[str], object]] = []
        self._forgot_s = 0.0

    def use(self, session: Session, speed: float = 1.0) -> None:
        """Run this session from now on. The owner closes the previous session.

        :param session: the new session.
        :param speed: simulated seconds per real second.
        """
        self.leave_network()
        self.network = None
        self.listeners = []
        self.session = session
        session.steps_launches = self.steps_launches
        self.time = RealTime(session.sim, speed)
        self._forgot_s = session.sim.elapsed_s

    def run_due(self) -> float | None:
        """Run the due items. Return the seconds until the next item is due, or None if there is no item."""
        wait_s = self.time.advance()
        if self.network is not None:
            self.network.after_turn()
        self.forget()
        return wait_s

    def forget(self) -> None:
        """Drop old messages at intervals, so that the memory of a machine that runs for hours does not grow."""
        sim = self.session.sim
        if self.keep_s is not None and sim.elapsed_s - self._forgot_s >= FORGET_EVERY_S:
            self._forgot_s = sim.elapsed_s
            self.session.host.forget_overlays()
            self.session.recorder.forget_before(sim.now_ns - round(self.keep_s * 1e9), MESSAGES_KEPT)

    def show_pages(self) -> None:
        """Send updates to the pages that are due."""
        for page in list(self.pages):
            page.show()

    # -- requests of pages

    def soon(self, action: Callable[[], object]) -> None:
        """Run a function on the machine's thread. Any thread may call this method."""
        raise NotImplementedError

    def do_for(self, viewer: Viewer, request: dict[str, Any]) -> None:
        """Handle a request from the page of a viewer."""
        with in_its_turn():
            viewer.take(request)

    # -- the real network

    def tell(self, text: str) -> None:
        """Show a message to the users, and add it to the recording."""
        self.session.recorder.note(None, 'network', text)
        for listener in self.listeners:
            listener(text)

    def switch(self) -> Network:
        """Return the connection to a real network. The first call creates it.

        :raises UnusableInput: when no plug-in provides a network.
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
        """Return whether the machine is now connected to a real network."""
        return self.network is not None and self.network.is_on

    @property
    def is_on_network(self) -> bool | None:
        """Return whether the machine is connected to a real network, or None if Cyclone DDS is not installed."""
        return self.has_joined if self.network is not None or can_join_network() else None

    def join_network(self, joins: bool) -> str:
        """Join or leave a real network for a page, with the environment of the machine's process. Return a message.

        :param joins: whether to join; otherwise, leave.
        """
        printed: list[str] = []
        self.switch().run(['on' if joins else 'off'], os.environ, printed.append, self.tell)
        return ''.join(printed).strip()

    def leave_network(self) -> None:
        """Leave the real network if the machine is connected to one."""
        if self.network is not None:
            self.network.off()


@contextmanager
def in_its_turn() -> Iterator[None]:
    """Return a context manager in which a machine runs from the asyncio loop of a notebook."""
    with outer_loop_set_aside(), streams_of_programs():
        yield


def finish(
    session: Session, process: Process, seconds: float, on_late: Callable[[bool], object] = lambda interrupted: None
) -> None:
    """Run until a command has ended. After `seconds`, send it SIGINT, and kill it if that does not end it.

    The `on_exit` function of the command must stop the simulation.

    :param session: the session that runs the command.
    :param process: the process of the command.
    :param seconds: the simulated time in seconds.
    :param on_late: called before SIGINT is sent, with True if the user has interrupted the run.
    """
    interrupted = session.run(seconds)
    if process.returncode is None:
        on_late(interrupted)
        process.send_signal(Signals.SIGINT)
        session.run(PATIENCE_S)
    if process.returncode is None:
        process.send_signal(Signals.SIGKILL)


def end_programs(session: Session, programs: Sequence[Process]) -> None:
    """Send SIGINT to some programs, wait :data:`PATIENCE_S` simulated seconds for their end, and kill the programs that
    remain.
    """
    left = [program for program in programs if program.returncode is None]
    for program in left:
        program.send_signal(Signals.SIGINT)
    latest_ns = session.sim.now_ns + round(PATIENCE_S * 1e9)
    while any(program.returncode is None for program in left) and session.sim.now_ns < latest_ns:
        session.run(0.1)
    for program in left:
        program.send_signal(Signals.SIGKILL)
    session.run(0.0)
