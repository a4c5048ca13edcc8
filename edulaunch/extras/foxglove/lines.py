"""The connection of a web socket with the object that handles its client.

This object is in the machine's process or, for a recording, in this process.
"""

from __future__ import annotations

import socket
from typing import Protocol

from tornado.iostream import IOStream

from edulaunch.desk.machine import wire
from edulaunch.extras.foxglove.conversation import Conversation
from edulaunch.extras.foxglove.server_messages import Message
from edulaunch.runtime.framing import Frames, frame

TEXT, BYTES, TURN = b'tbn'
"""The kinds of frames to the machine: a string of the client, bytes of the client, or a request for a turn."""
_LAST = ord('e')
END = frame(_LAST)
"""The kind of the frame after the last message of a turn."""


def packed(message: Message) -> bytes:
    """Return a message as a frame for the connection between the machine's process and the server's process."""
    return frame(TEXT, message.encode()) if isinstance(message, str) else frame(BYTES, message)


class Line(Protocol):
    """The connection of a web socket with the Conversation that handles its client."""

    async def say(self, message: Message) -> None:
        """Pass a message of the client to the conversation."""

    async def turn(self) -> list[Message]:
        """Return the messages for the client."""

    def close(self) -> None:
        """Release the resources of a client that has disconnected."""


class MachineLine:
    """The connection to a Conversation in the machine's process.

    :param connection: a socket that is connected to the machine.
    :param hello: the first frame to send on the socket.
    """

    def __init__(self, connection: socket.socket, hello: bytes) -> None:
        self._stream = IOStream(connection)
        self._frames = Frames(wire.FROM_MACHINE)
        self._messages = Frames()
        self._hello = hello

    async def _send(self, payload: bytes) -> None:
        hello, self._hello = self._hello, b''
        await self._stream.write(hello + frame(wire.INPUT, payload))

    async def say(self, message: Message) -> None:
        await self._send(packed(message))

    async def turn(self) -> list[Message]:
        """Return the messages for the client.

        :raises StreamClosedError: when the machine has ended.
        :raises OSError: when the machine accepts no more clients, with the machine's message.
        """
        await self._send(frame(TURN))
        found: list[Message] = []
        while True:
            for kind, payload in self._frames.feed(await self._stream.read_bytes(1 << 18, partial=True)):
                if kind == wire.ERRORS:
                    raise OSError(payload.decode('utf-8', 'replace'))
                if kind == wire.OUTPUT:
                    self._messages.add(payload)
            while (message := self._messages.take()) is not None:
                mark, data = message
                if mark == _LAST:
                    return found
                found.append(data.decode() if mark == TEXT else data)

    def close(self) -> None:
        self._stream.close()


class HereLine:
    """The connection with a Conversation in this process."""

    def __init__(self, conversation: Conversation) -> None:
        self._conversation = conversation

    async def say(self, message: Message) -> None:
        self._conversation.take(message)

    async def turn(self) -> list[Message]:
        return self._conversation.turn()

    def close(self) -> None:
        self._conversation.close()
