"""The machine's end of one connection: bytes in and out, who may speak, and the keyboard that is there."""

from __future__ import annotations

import hmac
import selectors
import socket
import sys
import time
import traceback
from collections import deque
from collections.abc import Callable
from typing import TYPE_CHECKING, Protocol

from edulaunch.desk.machine import wire
from edulaunch.engine.processes.inputs import PipedInput

if TYPE_CHECKING:
    from edulaunch.engine.processes.process import Process

MOST_UNREAD = 32 << 20
"""Bytes that wait for a terminal that does not read; with more it is taken for dead."""
CHUNK = 1 << 16
SOON_S = 0.02


class Peer(Protocol):
    """What a connection becomes once the other side has said who it is: a terminal, or a live page."""

    def take(self, kind: bytes, payload: bytes) -> None:
        """The other side has sent a frame."""

    def hang_up(self) -> None:
        """The other side is gone."""


class Connection:
    """One accepted connection. It says nothing, and nothing is done for it, before it has said the token.

    :param open_peer: makes the terminal or live page that the first frame asks for.
    :param forget: called once, when it is closed.
    :ivar terminal: what it became, if it is one.
    """

    def __init__(
        self,
        client: socket.socket,
        selector: selectors.BaseSelector,
        token: str,
        open_peer: Callable[[Connection, list[str]], Peer],
        forget: Callable[[Connection], object],
    ) -> None:
        self._socket = client
        self._selector = selector
        self._token = token
        self._open_peer = open_peer
        self._forget = forget
        self._frames = wire.Frames(wire.FROM_TERMINAL)
        self._unsent = bytearray()
        self._is_last = False
        self._events = selectors.EVENT_READ
        self._received: deque[tuple[bytes, bytes]] = deque()
        self.is_open = True
        self.since_s = self._flushed_s = time.monotonic()
        self.terminal: Peer | None = None
        client.setblocking(False)
        selector.register(client, self._events, self._attend)

    def send(self, kind: bytes, payload: bytes = b'') -> None:
        """Say something; it leaves with the next :meth:`flush`, or now when that is long ago: some turns last."""
        for begin in range(0, len(payload) or 1, wire.LONGEST):
            self._unsent += wire.frame(kind, payload[begin : begin + wire.LONGEST])
        if time.monotonic() - self._flushed_s > SOON_S:
            self._push()

    def end(self) -> None:
        """Close as soon as everything is said."""
        self._is_last = True

    def flush(self) -> None:
        """Send what waits, as far as the other side takes it."""
        if not self.is_open:
            return
        is_there = self._push()
        if not is_there or len(self._unsent) > MOST_UNREAD or (self._is_last and not self._unsent):
            self.close()
            return
        events = selectors.EVENT_READ | (selectors.EVENT_WRITE if self._unsent else 0)
        if events != self._events:
            self._events = events
            self._selector.modify(self._socket, events, self._attend)

    def _push(self) -> bool:
        """Send as much as goes; False when the other side is gone."""
        self._flushed_s = time.monotonic()
        try:
            while self._unsent and self.is_open:
                del self._unsent[: self._socket.send(self._unsent[:CHUNK])]
        except BlockingIOError:
            pass
        except OSError:
            return False
        return True

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
            is_good = self._read()
            self.take_received()
            if not is_good:
                self.close()

    def _read(self) -> bool:
        """Hear what has come; False when nothing good will come any more."""
        try:
            data = self._socket.recv(CHUNK)
            self._received += self._frames.feed(data)
        except BlockingIOError:
            return True
        except (OSError, wire.BadFrame):
            return False
        return bool(data)

    def take_received(self) -> None:
        """Do what was said. What makes no sense closes the connection."""
        try:
            while self._received and self.is_open:
                self._take(*self._received.popleft())
        except (wire.BadFrame, ValueError, IndexError):
            self.close()
        except Exception:  # a mistake of ours: the machine and its other terminals go on
            traceback.print_exc(file=sys.__stderr__)
            self.close()

    def look_for_signals(self, deliver: Callable[[int], object]) -> None:
        """While a program of the terminal keeps its turn: let Ctrl-C, and the end of the terminal, reach it.

        :raises BaseException: what the signal raises in the program, here in the midst of its code.
        """
        if not self._read():
            self.close()
        for message in [message for message in self._received if message[0] == wire.SIGNAL]:
            self._received.remove(message)
            self._answer()
            deliver(int(message[1]))

    def _answer(self) -> None:
        """Let the other end know at once that its signal is here: a program may keep its turn for long after it."""
        self.send(wire.ANSWER)
        self._push()

    def _take(self, kind: bytes, payload: bytes) -> None:
        if self.terminal is not None:
            if kind == wire.SIGNAL:
                self._answer()
            self.terminal.take(kind, payload)
            return
        fields = wire.unpack(payload) if kind == wire.HELLO else ['']
        if not hmac.compare_digest(fields[0].encode('utf-8', 'replace'), self._token.encode()):
            raise wire.BadFrame('not the token')
        self.send(wire.WELCOME)
        self.terminal = self._open_peer(self, fields[1:])


class RemoteInput(PipedInput):
    """What somebody types elsewhere. The other end reads its keyboard only once a program here does.

    :param send: tells the other end something.
    :param is_terminal: whether there is a keyboard, or a pipe or a file.
    :ivar size: columns and lines of the terminal.
    """

    is_inherited = True

    def __init__(self, send: Callable[..., object], is_terminal: bool, size: tuple[int, int]) -> None:
        super().__init__()
        self.size = size
        self._send = send
        self._is_terminal = is_terminal
        self._mode = wire.PLAIN_MODE
        self._is_wanted = False

    def isatty(self) -> bool:
        """Whether somebody sits there."""
        return self._is_terminal

    def terminal_size(self) -> tuple[int, int]:
        """Of the window at the other end."""
        return self.size if self._is_terminal else super().terminal_size()

    def take_due(self) -> None:
        """A program reads, or looks whether there is something to read."""
        if not self._is_wanted:
            self._is_wanted = True
            self._send(wire.READ)

    def change_mode(self, process: Process, flags: int) -> None:
        """Let the other end's terminal give keys or lines, as the program asks for."""
        import termios

        super().change_mode(process, flags)
        signs = ((wire.CANONICAL, termios.ICANON), (wire.ECHO, termios.ECHO), (wire.SIGNALS, termios.ISIG))
        mode = sum(sign for sign, flag in signs if flags & flag)
        if self._is_terminal and mode != self._mode:
            self._mode = mode
            self._send(wire.MODE, str(mode).encode())
