"""Lets terminals reach the machine of a notebook, on the notebook's own asyncio loop.

Between two cells time stands still, so that a lesson runs the same each time. While a terminal is connected it goes on, with the
clock on the wall.
"""

from __future__ import annotations

import asyncio
import atexit
import socket
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from typing import TYPE_CHECKING, Any

from edulaunch.machine.outer_loop import outer_loop_set_aside
from edulaunch.machine.place import Address, UnsafePlace, domain, folder, locked, read_address, remove_address, write_address
from edulaunch.machine.server import LOOK_EVERY_S, Server
from edulaunch.machine.snapshot import snapshot
from edulaunch.machine.starting import listen
from edulaunch.processes.streams import streams_of_programs
from edulaunch.session import Session
from edulaunch.sim.pacing import RealTime

if TYPE_CHECKING:
    from edulaunch.machine.desk_widget import Page
    from edulaunch.recording import Recording
    from edulaunch.view.viewer import Viewer

SHOWN_EVERY_S = 1 / 30


class Hosting:
    """The door of a notebook's machine. Without a loop that runs there is none, nor where the system forbids it."""

    def __init__(self) -> None:
        self._server: Server | None = None
        self._loop: asyncio.AbstractEventLoop | None = None
        self._next: asyncio.TimerHandle | None = None
        self._door: tuple[str, str, Address] | None = None
        self._is_going = False
        self.pages: list[Page] = []

    def has_terminals(self) -> bool:
        """Whether anybody is connected, or looks at a desk."""
        return self._server is not None and (self._server.has_terminals() or any(page.is_shown() for page in self.pages))

    def has_programs(self) -> bool:
        """Whether programs may have been left running in a terminal, or in one of a desk. To look at a desk is not enough."""
        if self._server is None:
            return False
        return self._server.has_terminals() or any(page.viewer.has_programs() for page in self.pages)

    # What a desk in the notebook needs of its machine, see `edulaunch.view.viewer.Living` and `DeskWidget`.

    can_continue = False

    @property
    def session(self) -> Session:
        """What runs on the machine."""
        assert self._server is not None
        return self._server.session

    @property
    def time(self) -> RealTime:
        """How its time passes while somebody looks."""
        assert self._server is not None
        return self._server.time

    def recording(self) -> Recording:
        """What happened until now."""
        return snapshot(self.session)

    def took(self, words: dict[str, Any]) -> None:
        """A page asked for this; cells cannot be repeated."""

    def continue_at(self, time_s: float) -> None:
        """A notebook's machine cannot: its cells are not known."""

    is_on_network = None

    def join_network(self, joins: bool) -> str:
        """Only the machine of the terminals meets real nodes: its clock is the wall's."""
        return 'only the machine of the terminals can join a network: edulaunch network on'

    def soon(self, action: Callable[[], object]) -> None:
        """Do something where the machine runs, and look again at what is due; from any thread."""

        def act() -> None:
            action()
            self._look_again(0.0)

        if self._loop is not None:
            self._loop.call_soon_threadsafe(act)

    def do_for(self, viewer: Viewer, words: dict[str, Any]) -> None:
        """What the page of a viewer asks for."""
        with outer_loop_set_aside(), streams_of_programs():
            viewer.take(words)

    def serve(self, session: Session) -> None:
        """From now on terminals find this session; the notebook that was used last is the one that they find."""
        if self._loop is None:
            return
        try:
            if self._server is None:
                self._open(session, self._loop)
            elif self._server.session is not session:
                self._server.move_to(session)
            self._claim()
        except (NotImplementedError, OSError, UnsafePlace):
            self._loop = None

    def _open(self, session: Session, loop: asyncio.AbstractEventLoop) -> None:
        place, number = folder(), domain()
        listener, address = listen(place, number, 'notebook')
        self._door = place, number, address
        self._server = Server(session, listener, address.token)
        loop.add_reader(_number(self._server), self._heard)
        atexit.register(remove_address, place, number, address)

    def _claim(self) -> None:
        assert self._door is not None
        place, number, address = self._door
        found = read_address(place, number)
        if found is None or found.token != address.token:
            with locked(place, number):
                write_address(place, number, address)

    @contextmanager
    def cell(self) -> Iterator[None]:
        """Around a cell that lets time pass: for terminals it goes on from where that has come to."""
        with suppress(RuntimeError):
            self._loop = asyncio.get_running_loop()
        try:
            yield
        finally:
            if self._server is not None:
                self._server.time.go_on()
                self._server.flush()
                self._look_again(0.0)

    def _heard(self) -> None:
        """Somebody has said something."""
        server = self._server
        assert server is not None
        with outer_loop_set_aside(), streams_of_programs():
            server.listen(0)
        self._look_again(0.0)

    def _go_on(self) -> None:
        """Run what is due, for as long as anybody is connected."""
        server = self._server
        assert server is not None
        if not self.has_terminals():
            self._is_going = False
            return
        if not self._is_going:
            self._is_going = True
            server.time.go_on()
        host = server.session.host
        host.is_paced = True
        try:
            with outer_loop_set_aside(), streams_of_programs():
                due_s = server.run_due()
        finally:
            host.is_paced = False
        server.drop_the_silent()
        for page in list(self.pages):
            page.show()
        if any(page.is_shown() for page in self.pages):
            due_s = min(SHOWN_EVERY_S, SHOWN_EVERY_S if due_s is None else due_s)
        self._look_again(LOOK_EVERY_S if due_s is None else min(due_s, LOOK_EVERY_S))

    def _look_again(self, seconds: float) -> None:
        if self._next is not None:
            self._next.cancel()
        if self._loop is not None and not self._loop.is_closed():
            self._next = self._loop.call_later(seconds, self._go_on)


def _number(server: Server) -> int:
    """What a loop has to wait for to hear any terminal.

    :raises NotImplementedError: on systems where a set of connections is not one file.
    """
    number = getattr(server.selector, 'fileno', None)
    if number is None or not hasattr(socket, 'AF_UNIX'):
        raise NotImplementedError
    return int(number())
