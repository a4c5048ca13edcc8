"""A client of the protocol for tests, written from the protocol's description: it shares no code with the server."""

from __future__ import annotations

import asyncio
import json
import struct
from collections.abc import Callable
from typing import Any

from tornado.httpclient import HTTPRequest
from tornado.websocket import WebSocketClientConnection, websocket_connect

SDK, OLD = 'foxglove.sdk.v1', 'foxglove.websocket.v1'
PATIENCE_S = 60.0
"""Real seconds after which something will never come; nothing is measured by it."""


class FoxgloveClient:
    """One connection, and everything that came over it, in order."""

    def __init__(self, socket: WebSocketClientConnection) -> None:
        self.socket = socket
        self.is_closed = False
        self.texts: list[dict[str, Any]] = []
        self.binary: list[bytes] = []
        self.channels: dict[str, dict[str, Any]] = {}
        self.services: dict[str, dict[str, Any]] = {}

    @classmethod
    async def connect(cls, url: str, protocol: str = SDK, **headers: str) -> FoxgloveClient:
        """Connect, or raise what the server answers."""
        return cls(await websocket_connect(HTTPRequest(url, headers=headers), subprotocols=[protocol], max_message_size=64 << 20))

    async def close(self) -> None:
        """Say goodbye, and read until the server has said it, too."""
        self.socket.close()
        while not self.is_closed:
            await self.read()

    async def read(self) -> bool:
        """Take one message; False when the connection is closed."""
        message = await asyncio.wait_for(self.socket.read_message(), PATIENCE_S)
        if message is None:
            self.is_closed = True
            self.socket.close()
            return False
        if isinstance(message, bytes):
            self.binary.append(message)
            return True
        said = json.loads(message)
        self.texts.append(said)
        self.channels |= {row['topic']: row for row in said.get('channels', ())}
        self.services |= {row['name']: row for row in said.get('services', ())}
        return True

    async def until(self, ready: Callable[[], Any]) -> Any:
        """Read until something is so."""
        while not (found := ready()):
            assert await self.read(), f'closed: {self.texts[-3:]}'
        return found

    async def op(self, operation: str, **fields: Any) -> None:
        """Say something in JSON."""
        await self.socket.write_message(json.dumps({'op': operation, **fields}))

    async def raw(self, data: bytes) -> None:
        """Say something in bytes."""
        await self.socket.write_message(data, binary=True)

    async def subscribe(self, topic: str, number: int) -> None:
        """Subscribe as soon as the topic is there."""
        channel = await self.until(lambda: self.channels.get(topic))
        await self.op('subscribe', subscriptions=[{'id': number, 'channelId': channel['id']}])

    def data(self, number: int) -> list[tuple[int, bytes]]:
        """(time in ns, CDR) of all messages of a subscription."""
        rows = [(struct.unpack_from('<IQ', one, 1), one[13:]) for one in self.binary if one[0] == 1]
        return [(time_ns, cdr) for (subscription, time_ns), cdr in rows if subscription == number]

    def said(self, operation: str) -> list[dict[str, Any]]:
        """What came of one operation."""
        return [text for text in self.texts if text['op'] == operation]

    async def publish(self, number: int, cdr: bytes) -> None:
        """Publish on one of our channels."""
        await self.raw(struct.pack('<BI', 1, number) + cdr)
