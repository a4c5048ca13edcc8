"""The process that hosts a machine: one Session in real time, and the terminals that are connected to it."""

from __future__ import annotations

import gc
import os
import selectors
import signal
import socket
import sys
import time
from collections.abc import Callable
from importlib import import_module

from edulaunch.machine.connection import Connection
from edulaunch.machine.place import LISTENER, locked, read_address, remove_address
from edulaunch.machine.terminals import Terminals
from edulaunch.processes.shared_streams import streams_of_programs
from edulaunch.session import Session
from edulaunch.sim.pacing import RealTime

GRACE_S = 10.0
"""Seconds that a machine waits for another terminal after the last one has gone."""
MOST_CONNECTIONS = 512
HELLO_WITHIN_S = 5.0
EARLY = ('rclpy', 'launch', 'launch_ros.actions')
"""What most commands need; loaded while nothing else is to be done."""


class Server:
    """Serves terminals on a listening socket, with one Session behind them.

    Everything happens in :meth:`attend`, which never waits longer than it is told: a loop of its own (:meth:`serve`) or somebody
    else's (a notebook's) calls it.

    :param token: what a terminal has to say first.
    """

    def __init__(self, session: Session, listener: socket.socket, token: str) -> None:
        self.session = session
        self.time = RealTime(session.sim)
        self.terminals = Terminals(session, self.time)
        self.selector = selectors.DefaultSelector()
        self.is_asked_to_end = False
        self.last_seen_s = time.monotonic()
        self._listener = listener
        self._token = token
        self._connections: list[Connection] = []
        session.host.is_paced = True
        listener.setblocking(False)
        self.selector.register(listener, selectors.EVENT_READ, self._accept)

    def attend(self, longest_s: float | None = None) -> None:
        """Run what is due, hand on what was said, and wait at most until something is due or `longest_s`."""
        wait_s = self.time.advance()
        for connection in list(self._connections):
            connection.flush()
        waits = [seconds for seconds in (wait_s, longest_s) if seconds is not None]
        for key, events in self.selector.select(min(waits) if waits else None):
            self.time.advance()  # what was typed is typed now, not when something was due last
            take: Callable[[int], object] = key.data
            take(events)

    def next_s(self) -> float | None:
        """Seconds until :meth:`attend` has something to do, if nobody says anything."""
        return self.time.advance()

    def has_terminals(self) -> bool:
        """Whether anybody is connected."""
        return bool(self._connections)

    def _accept(self, events: int) -> None:
        try:
            client, _ = self._listener.accept()
        except OSError:
            return
        if len(self._connections) >= MOST_CONNECTIONS or not _is_ours(client):
            client.close()
            return
        self._connections.append(Connection(client, self.selector, self._token, self.terminals, self._forget))

    def _forget(self, connection: Connection) -> None:
        self._connections.remove(connection)
        self.last_seen_s = time.monotonic()

    def drop_the_silent(self) -> None:
        """Close connections that did not say who they are in time."""
        late = time.monotonic() - HELLO_WITHIN_S
        for connection in list(self._connections):
            if connection.terminal is None and connection.since_s < late:
                connection.close()

    def close(self) -> None:
        """Let every terminal go."""
        for connection in list(self._connections):
            connection.close()
        self.selector.close()
        self._listener.close()


def _is_ours(client: socket.socket) -> bool:
    """Whether the other end is a program of this user, as far as the system can tell."""
    if client.family == getattr(socket, 'AF_UNIX', None) and hasattr(socket, 'SO_PEERCRED'):
        credentials = client.getsockopt(socket.SOL_SOCKET, socket.SO_PEERCRED, 12)
        return int.from_bytes(credentials[4:8], sys.byteorder) == os.geteuid()
    return True


def serve(server: Server, place: str, number: str, token: str) -> None:
    """Serve until the last terminal has been gone for a while, or somebody says so."""
    early = list(EARLY)
    while True:
        if server.is_asked_to_end or server.terminals.is_asked_to_end:
            break
        quiet_s = time.monotonic() - server.last_seen_s
        if not server.has_terminals() and quiet_s > _grace_s():
            break
        longest_s = None if server.has_terminals() and not early else 0.05 if early else _grace_s() - quiet_s + 0.01
        before = time.monotonic()
        server.attend(longest_s)
        if early and time.monotonic() - before > 0.04:
            import_module(early.pop(0))
        server.drop_the_silent()
    with locked(place, number):
        remove_address(place, number, token)
    server.close()


def _grace_s() -> float:
    try:
        return float(os.environ.get('EDULAUNCH_GRACE_S', GRACE_S))
    except ValueError:
        return GRACE_S


def main() -> None:
    """The program of a machine: `python -m edulaunch.machine.server FOLDER DOMAIN`, with the listening socket as number 3."""
    place, number = sys.argv[1:3]
    listener = socket.socket(fileno=LISTENER)
    with locked(place, number):  # whoever started us has written the address by then
        address = read_address(place, number)
    if address is None or address.pid != os.getpid():
        return
    for name in ('SIGINT', 'SIGHUP'):
        signal.signal(getattr(signal, name), signal.SIG_IGN)
    session = Session(start_ns=time.time_ns(), console=None)
    server = Server(session, listener, address.token)
    signal.signal(signal.SIGTERM, lambda signum, frame: setattr(server, 'is_asked_to_end', True))
    gc.freeze()
    with streams_of_programs():
        serve(server, place, number, address.token)
    session.close()


if __name__ == '__main__':
    main()
