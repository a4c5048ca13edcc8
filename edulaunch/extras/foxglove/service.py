"""The service of the machine for `edulaunch view --foxglove`, with one Conversation for each client.

The server of web sockets is a process between the machine and the clients. The machine sends nothing until this server requests
a turn. A client that does not read therefore causes no work for the machine.
"""

from __future__ import annotations

from itertools import count

from edulaunch.desk.machine import wire
from edulaunch.desk.machine.connection import Connection
from edulaunch.desk.machine.live import LiveMachine
from edulaunch.extras.foxglove.conversation import Conversation
from edulaunch.extras.foxglove.lines import BYTES, END, TEXT, TURN, packed
from edulaunch.extras.foxglove.live import LiveFeed
from edulaunch.runtime.framing import Frames

MOST_CLIENTS = 16
_numbers = count(1)
_clients: list[Client] = []


class Client:
    """A client of the server, in place of a terminal. It receives the same frames as a terminal."""

    def __init__(self, machine: LiveMachine, connection: Connection) -> None:
        self._connection = connection
        self._frames = Frames()
        self._conversation = Conversation(LiveFeed(machine, next(_numbers)))
        _clients.append(self)

    def take(self, kind: int, payload: bytes) -> None:
        """Handle a message of the client, or the server's request for a turn.

        :raises ValueError: when the client sends requests faster than it reads the replies, and for an invalid payload.
        """
        if kind != wire.INPUT:
            return
        for mark, data in self._frames.feed(payload):
            if mark == TURN:
                messages = b''.join(map(packed, self._conversation.turn()))
                self._connection.send(wire.OUTPUT, messages + END)
            elif mark in (TEXT, BYTES):
                self._conversation.take(data.decode() if mark == TEXT else data)

    def hang_up(self) -> None:
        """Release the resources of a client that has disconnected."""
        _clients.remove(self)
        self._conversation.close()


def peer(machine: LiveMachine, connection: Connection) -> Client:
    """Return the object that handles a new client."""
    if len(_clients) >= MOST_CLIENTS:
        connection.send(wire.ERRORS, f'{MOST_CLIENTS} clients are connected already'.encode())
        connection.end()
    return Client(machine, connection)
