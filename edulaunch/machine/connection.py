"""The machine's end of one connection: bytes in and out, and who may speak."""

from __future__ import annotations

import hmac
import selectors
import socket
import sys
import time
import traceback
from collections.abc import Callable
from typing import TYPE_CHECKING

from edulaunch.machine import wire

if TYPE_CHECKING:
    from edulaunch.machine.desk import Desk
    from edulaunch.machine.terminals import Terminal, Terminals

MOST_UNREAD = 32 << 20
"""Bytes that wait for a terminal that does not read; with more it is taken for dead."""
CHUNK = 1 << 16


class Connection:
    """One accepted connection. It says nothing, and nothing is done for it, before it has said the token.

    :param forget: called once, when it is closed.
    :ivar terminal: what it became, if it is one.
    """

    def __init__(
        self,
        client: socket.socket,
        selector: selectors.BaseSelector,
        token: str,
        terminals: Terminals,
        forget: Callable[[Connection], object],
    ) -> None:
        self._socket = client
        self._selector = selector
        self._token = token
        self._terminals = terminals
        self._forget = forget
        self._frames = wire.Frames(wire.FROM_TERMINAL)
        self._unsent = bytearray()
        self._is_last = False
        self._events = selectors.EVENT_READ
        self.is_open = True
        self.since_s = time.monotonic()
        self.terminal: Terminal | Desk | None = None
        client.setblocking(False)
        selector.register(client, self._events, self._attend)

    def send(self, kind: bytes, payload: bytes = b'') -> None:
        """Say something; it leaves with the next :meth:`flush`."""
        for begin in range(0, len(payload) or 1, wire.LONGEST):
            self._unsent += wire.frame(kind, payload[begin : begin + wire.LONGEST])

    def end(self) -> None:
        """Close as soon as everything is said."""
        self._is_last = True

    def flush(self) -> None:
        """Send what waits, as far as the other side takes it."""
        if not self.is_open:
            return
        try:
            while self._unsent:
                del self._unsent[: self._socket.send(self._unsent[:CHUNK])]
        except BlockingIOError:
            pass
        except OSError:
            self.close()
            return
        if len(self._unsent) > MOST_UNREAD or (self._is_last and not self._unsent):
            self.close()
            return
        events = selectors.EVENT_READ | (selectors.EVENT_WRITE if self._unsent else 0)
        if events != self._events:
            self._events = events
            self._selector.modify(self._socket, events, self._attend)

    def close(self) -> None:
        """The other side is gone, or has to go: its programs end as those of a closed terminal."""
        if self.is_open:
            self.is_open = False
            self._selector.unregister(self._socket)
            self._socket.close()
            self._forget(self)
            if self.terminal is not None:
                self.terminal.hang_up()

    def _attend(self, events: int) -> None:
        if events & selectors.EVENT_READ and self.is_open:
            self._read()

    def _read(self) -> None:
        try:
            data = self._socket.recv(CHUNK)
        except BlockingIOError:
            return
        except OSError:
            data = b''
        try:
            for kind, payload in self._frames.feed(data):
                self._take(kind, payload)
        except (wire.BadFrame, ValueError, IndexError):
            data = b''
        except Exception:  # a mistake of ours: the machine and its other terminals go on
            traceback.print_exc(file=sys.__stderr__)
            data = b''
        if not data:
            self.close()

    def _take(self, kind: bytes, payload: bytes) -> None:
        if self.terminal is not None:
            self.terminal.take(kind, payload)
            return
        fields = wire.unpack(payload) if kind == wire.HELLO else ['']
        if not hmac.compare_digest(fields[0].encode('utf-8', 'replace'), self._token.encode()):
            raise wire.BadFrame('not the token')
        self.send(wire.WELCOME)
        self.terminal = self._terminals.open(self, fields[1:])
