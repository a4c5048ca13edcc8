"""Connect terminals to the machine of a notebook, with the notebook's own asyncio loop.

Simulated time does not pass between two cells, so that a lesson runs in the same way each time. While a terminal is connected,
simulated time follows real time.
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
    """The server of a notebook's machine. It needs a running asyncio loop that can wait for connections.

    :ivar joins_next: whether the next machine of the notebook joins a real network.
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
        """Return whether programs may still run in a terminal, or in a terminal of a live view.

        A live view alone does not count.
        """
        if self._server is None:
            return False
        return self._server.has_terminals() or self._has_joined() or any(page.viewer.has_programs() for page in self.pages)

    def soon(self, action: Callable[[], object]) -> None:
        """Run a function on the machine's thread, then run the items that are due. Any thread may call this method."""

        def act() -> None:
            action()
            self._look_again(0.0)

        if self._loop is not None:
            self._loop.call_soon_threadsafe(act)

    @property
    def is_on_network(self) -> bool | None:
        """Return the same as `LiveMachine.is_on_network`, or None without a server."""
        return None if self._server is None else super().is_on_network

    def _has_joined(self) -> bool:
        return self._server is not None and self.has_joined

    def join_network(self, joins: bool) -> str:
        """Join or leave a real network. Return a message. After joining, simulated time follows real time.

        A simulation that runs already keeps its own time. If that time is far from real time, the next launch joins instead.

        :param joins: whether to join; otherwise, leave.
        """
        assert self._server is not None
        self.joins_next = joins and not is_walls_time(self.session.sim.now_ns)
        if self.joins_next:
            return 'the next %ros2 launch joins the network, in real time; the launch of now keeps its simulated time'
        answer = super().join_network(joins)
        self._look_again(0.0)
        return answer

    def serve(self, session: Session) -> None:
        """Let terminals use this session from now on. Terminals find the notebook that was used last."""
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
        """Return a context manager for a cell that runs the machine. Afterwards, real-time pacing continues from the new time."""
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
        """Read the input of terminals."""
        server = self._server
        assert server is not None
        with in_its_turn():
            server.listen(0)
        self._look_again(0.0)

    def _go_on(self) -> None:
        """Run the due items while a terminal is connected, a page is visible, or the machine is on a real network."""
        server = self._server
        assert server is not None
        is_seen = any(page.is_shown() for page in self.pages)
        if not (is_seen or server.has_terminals() or self._has_joined()):
            self._is_going = False
            return
        if not self._is_going:
            self._is_going = True
            self.time.go_on()
        with in_its_turn():
            due_s = server.run_due()
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
    """Return the file descriptor that an asyncio loop must watch for input of all terminals.

    :raises NotImplementedError: on systems without such a file descriptor.
    """
    number = getattr(server.selector, 'fileno', None)
    if number is None or not hasattr(socket, 'AF_UNIX'):
        raise NotImplementedError
    return int(number())
