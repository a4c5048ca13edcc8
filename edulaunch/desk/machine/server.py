"""The server that connects terminals to a machine: one Session in real time, and all connections to it."""

from __future__ import annotations

import os
import selectors
import socket
import sys
import time
import traceback
from collections.abc import Callable
from functools import partial

from edulaunch.desk.machine.connection import Connection, Peer
from edulaunch.desk.machine.live import LiveMachine
from edulaunch.desk.machine.terminals import Terminal, Terminals
from edulaunch.runtime.session import Session

MOST_CONNECTIONS = 512
MOST_MISTAKES = 20
HELLO_WITHIN_S = 5.0
LOOK_EVERY_S = 5.0


class Server:
    """Serves terminals on a listening socket, and runs their commands on one live machine.

    All work happens in :meth:`run_due` and :meth:`listen`. The caller is the loop in `serving`, or a loop that waits on
    `selector` itself, such as the loop of a notebook.

    :param machine: a machine that already runs a session.
    :param token: the secret that a terminal must send first.
    :ivar is_listening: whether the server waits for input, and no program runs.
    :ivar rounds: the number of times that the server has waited for input.
    """

    def __init__(self, machine: LiveMachine, listener: socket.socket, token: str) -> None:
        self.machine = machine
        self.selector = machine.selector = selectors.DefaultSelector()
        self.terminals = Terminals(machine)
        self.is_asked_to_end = False
        self.is_listening = False
        self.rounds = 0
        self.is_behind = False
        self._mistakes = 0
        self.last_seen_s = time.monotonic()
        self.on_accept: Callable[[socket.socket], object] = lambda client: None
        self._listener = listener
        self._token = token
        self._connections: list[Connection] = []
        listener.setblocking(False)
        self.selector.register(listener, selectors.EVENT_READ, self._accept)

    def run_due(self) -> float | None:
        """Run the due items and send the output. Return the seconds until the next item is due, or None if there is no item."""
        wait_s = self.machine.run_due()
        self.flush()
        return wait_s

    def run_due_safely(self) -> float | None:
        """Call :meth:`run_due`. If the engine fails while it runs one program, log the error and continue with the other
        programs.

        :raises Exception: when the engine fails repeatedly.
        """
        try:
            due_s = self.run_due()
            self._mistakes = 0
        except Exception:
            self._mistakes += 1
            if self._mistakes >= MOST_MISTAKES:
                raise
            traceback.print_exc(file=sys.__stderr__)
            due_s = 0.0
        return due_s

    def flush(self) -> None:
        """Send the queued output of all connections."""
        for connection in list(self._connections):
            connection.flush()

    def listen(self, seconds: float | None) -> None:
        """Wait for input of terminals, and read it.

        :param seconds: the longest time to wait in seconds, or None to wait without a limit.
        """
        if self.is_behind:
            self.is_behind = False
            for connection in list(self._connections):
                connection.take_received()
        self.rounds += 1
        self.is_listening = True
        ready = self.selector.select(seconds)
        self.is_listening = False
        if ready:
            self.machine.time.advance()  # input gets the current time, not the time of the last due item
        for key, events in ready:
            take: Callable[[int], object] = key.data
            take(events)

    def look_for_signals(self) -> None:
        """Check whether the terminal of the running program has sent a signal to end it.

        This method is called while the program runs.
        """
        program = self.machine.session.host.program_here()
        for connection in list(self._connections):
            terminal = connection.terminal
            if program is not None and isinstance(terminal, Terminal) and terminal.process is program.group:
                self.is_behind = True
                connection.look_for_signals(partial(terminal.signal, running=program))

    def move_to(self, session: Session) -> None:
        """Use another session for all later connections."""
        self.machine.use(session)
        self.terminals = Terminals(self.machine)

    def has_connections(self) -> bool:
        """Return whether any connection is open, or the machine has joined a real network.

        A connection without a token counts.
        """
        return bool(self._connections) or self.machine.has_joined

    def has_terminals(self) -> bool:
        """Return whether a connection is open that has sent the token."""
        return any(connection.terminal is not None for connection in self._connections)

    def _accept(self, events: int) -> None:
        try:
            client, _ = self._listener.accept()
        except OSError:
            return
        try:
            if len(self._connections) < MOST_CONNECTIONS and _is_ours(client):
                self.on_accept(client)
                self._connections.append(Connection(client, self.selector, self._token, self._open_peer, self._forget))
                return
        except OSError as error:  # this computer lacks memory or descriptors: the programs of other terminals continue
            print(f'could not accept a terminal: {error}', file=sys.__stderr__)
        client.close()

    def _open_peer(self, connection: Connection, fields: list[str]) -> Peer:
        """Open a terminal or page in the current session. The session may have changed since the connection was accepted."""
        return self.terminals.open(connection, fields)

    def _forget(self, connection: Connection) -> None:
        self._connections.remove(connection)
        self.last_seen_s = time.monotonic()

    def drop_the_silent(self) -> None:
        """Close connections that have not sent the token in time."""
        late = time.monotonic() - HELLO_WITHIN_S
        for connection in list(self._connections):
            if connection.terminal is None and connection.since_s < late:
                connection.close()

    def close(self) -> None:
        """Leave the network, and close all connections and the listening socket."""
        self.machine.leave_network()
        for connection in list(self._connections):
            connection.close()
        self.selector.close()
        self._listener.close()


def _is_ours(client: socket.socket) -> bool:
    """Return whether the client is a program of this user. Return True if the system does not report the user."""
    if client.family == getattr(socket, 'AF_UNIX', None) and hasattr(socket, 'SO_PEERCRED'):
        credentials = client.getsockopt(socket.SOL_SOCKET, socket.SO_PEERCRED, 12)
        return int.from_bytes(credentials[4:8], sys.byteorder) == os.geteuid()
    return True
