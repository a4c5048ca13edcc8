"""What a web socket is connected to: a conversation in the machine's process, or one right here, for a recording."""

from __future__ import annotations

import socket
import struct
from typing import Protocol

from tornado.iostream import IOStream

from edulaunch.desk.machine import wire
from edulaunch.extras.foxglove.conversation import Conversation
from edulaunch.extras.foxglove.said import Message

TEXT, BYTES, TURN = b't', b'b', b'n'
"""What a frame to the machine holds: a string of the client, bytes of the client, or the wish for a turn."""
_LAST = b'e'
_HEADER = struct.Struct('<cI')
END = _HEADER.pack(_LAST, 0)
"""Behind the last message of a turn."""


def packed(message: Message) -> bytes:
    """Return a message as it goes from the machine's process to the server's."""
    data = message.encode() if isinstance(message, str) else message
    return _HEADER.pack(TEXT if isinstance(message, str) else BYTES, len(data)) + data


class Line(Protocol):
    """What a web socket is connected to."""

    async def say(self, message: Message) -> None:
        """The client says something."""

    async def turn(self) -> list[Message]:
        """The messages for the client."""

    def close(self) -> None:
        """The client is gone."""


class MachineLine:
    """A conversation in the machine's process.

    :param connection: a socket that is connected to the machine.
    :param hello: the first frame to say on it.
    """

    def __init__(self, connection: socket.socket, hello: bytes) -> None:
        self._stream = IOStream(connection)
        self._frames = wire.Frames(wire.FROM_MACHINE)
        self._data = bytearray()
        self._hello = hello

    async def _send(self, payload: bytes) -> None:
        hello, self._hello = self._hello, b''
        await self._stream.write(hello + wire.frame(wire.INPUT, payload))

    async def say(self, message: Message) -> None:
        await self._send(TEXT + message.encode() if isinstance(message, str) else BYTES + message)

    async def turn(self) -> list[Message]:
        """The messages for the client.

        :raises StreamClosedError: when the machine is gone.
        :raises OSError: with what the machine says when it takes no more clients.
        """
        await self._send(TURN)
        found: list[Message] = []
        while True:
            while len(self._data) >= _HEADER.size:
                mark, length = _HEADER.unpack_from(self._data)
                if len(self._data) < _HEADER.size + length:
                    break
                data = bytes(self._data[_HEADER.size : _HEADER.size + length])
                del self._data[: _HEADER.size + length]
                if mark == _LAST:
                    return found
                found.append(data.decode() if mark == TEXT else data)
            for kind, payload in self._frames.feed(await self._stream.read_bytes(1 << 18, partial=True)):
                if kind == wire.OUTPUT:
                    self._data += payload
                elif kind == wire.ERRORS:
                    raise OSError(payload.decode('utf-8', 'replace'))

    def close(self) -> None:
        self._stream.close()


class HereLine:
    """A conversation in this process."""

    def __init__(self, conversation: Conversation) -> None:
        self._conversation = conversation

    async def say(self, message: Message) -> None:
        self._conversation.take(message)

    async def turn(self) -> list[Message]:
        return self._conversation.turn()

    def close(self) -> None:
        self._conversation.close()
