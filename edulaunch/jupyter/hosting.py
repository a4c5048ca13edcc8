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

from edulaunch.desk.machine.live import SHOWN_EVERY_S, LiveMachine, in_its_turn
from edulaunch.desk.machine.network import is_walls_time
from edulaunch.desk.machine.place import (
    Address,
    UnsafePlace,
    domain,
    folder,
    listen,
    locked,
    read_address,
    remove_address,
    write_address,
)
from edulaunch.desk.machine.server import LOOK_EVERY_S, Server
from edulaunch.runtime.session import Session


class Hosting(LiveMachine):
    """The door of a notebook's machine. Without a loop that runs there is none, nor where the system forbids it.

    :ivar joins_next: whether the next machine joins a real network.
    """

    def __init__(self) -> None:
        super().__init__()
        self._server: Server | None = None
        self._loop: asyncio.AbstractEventLoop | None = None
        self._next: asyncio.TimerHandle | None = None
        self._door: tuple[str, str, Address] | None = None
        self._is_going = False
        self.joins_next = False

    def has_programs(self) -> bool:
        """Whether programs may have been left running in a terminal, or in one of a desk. To look at a desk is not enough."""
        if self._server is None:
            return False
        return self._server.has_terminals() or self._has_joined() or any(page.viewer.has_programs() for page in self.pages)

    def soon(self, action: Callable[[], object]) -> None:
        """Do something where the machine runs, and look again at what is due; from any thread."""

        def act() -> None:
            action()
            self._look_again(0.0)

        if self._loop is not None:
            self._loop.call_soon_threadsafe(act)

    @property
    def is_on_network(self) -> bool | None:
        """See `LiveMachine.is_on_network`."""
        return None if self._server is None else super().is_on_network

    def _has_joined(self) -> bool:
        return self._server is not None and self.has_joined

    def join_network(self, joins: bool) -> str:
        """Join, or leave; returns what to say. While it has joined time goes on by itself.

        What runs in the time of the simulation stays there: the next launch joins.
        """
        assert self._server is not None
        self.joins_next = joins and not is_walls_time(self.session.sim.now_ns)
        if self.joins_next:
            return "the next %ros2 launch joins the network: its clock is that of the wall, this one's is that of the simulation"
        answer = super().join_network(joins)
        self._look_again(0.0)
        return answer

    def serve(self, session: Session) -> None:
        """From now on terminals find this session; the notebook that was used last is the one that they find."""
        if self._loop is None:
            return
        try:
            if self._server is None:
                self.use(session)
                self._server = self._open(self._loop)
            elif self.session is not session:
                self._server.move_to(session)
            self._claim()
        except (NotImplementedError, OSError, UnsafePlace):
            self._loop = None

    def _open(self, loop: asyncio.AbstractEventLoop) -> Server:
        place, number = folder(), domain()
        listener, address = listen(place, number, 'notebook')
        self._door = place, number, address
        server = self._server = Server(self, listener, address.token)
        loop.add_reader(_number(server), self._on_readable)
        atexit.register(remove_address, place, number, address)
        return server

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
                self.time.go_on()
                self._server.flush()
                self._look_again(0.0)

    def _on_readable(self) -> None:
        """Somebody has said something."""
        server = self._server
        assert server is not None
        with in_its_turn():
            server.listen(0)
        self._look_again(0.0)

    def _go_on(self) -> None:
        """Run what is due, for as long as anybody is connected."""
        server = self._server
        assert server is not None
        is_seen = any(page.is_shown() for page in self.pages)
        if not (is_seen or server.has_terminals() or self._has_joined()):
            self._is_going = False
            return
        if not self._is_going:
            self._is_going = True
            self.time.go_on()
        host = self.session.host
        host.is_paced = True
        try:
            with in_its_turn():
                due_s = server.run_due()
        finally:
            host.is_paced = False
        server.drop_the_silent()
        self.show_pages()
        if is_seen:
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
