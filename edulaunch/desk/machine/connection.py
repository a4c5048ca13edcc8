"""The machine's side of one connection. It sends and receives bytes, checks the token, and provides the terminal's keyboard."""

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
from edulaunch.runtime.framing import BadFrame, Frames, frame

if TYPE_CHECKING:
    from edulaunch.engine.processes.process import Process

MOST_UNREAD = 32 << 20
"""If more bytes than this wait for a terminal that does not read, the connection is closed."""
CHUNK = 1 << 16
SOON_S = 0.02


class Peer(Protocol):
    """The object that receives the frames of a connection after the first frame: a terminal or a live view."""

    def take(self, kind: int, payload: bytes) -> None:
        """Handle a frame from the client."""

    def hang_up(self) -> None:
        """Handle the end of the connection."""


class Connection:
    """One accepted connection. It ignores all frames until the client has sent the token.

    :param open_peer: a function that creates the terminal or live view that the first frame requests.
    :param forget: a function that is called once when the connection is closed.
    :ivar terminal: the terminal or live view that uses the connection, or None before the first frame.
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
        self._frames = Frames(wire.FROM_TERMINAL)
        self._unsent = bytearray()
        self._is_last = False
        self._events = selectors.EVENT_READ
        self._received: deque[tuple[int, bytes]] = deque()
        self.is_open = True
        self.since_s = self._flushed_s = time.monotonic()
        self.terminal: Peer | None = None
        client.setblocking(False)
        selector.register(client, self._events, self._attend)

    def send(self, kind: int, payload: bytes = b'') -> None:
        """Queue a frame. The frame is sent with the next :meth:`flush`, or immediately if the last flush was long ago."""
        for begin in range(0, len(payload) or 1, wire.LONGEST):
            self._unsent += frame(kind, payload[begin : begin + wire.LONGEST])
        if time.monotonic() - self._flushed_s > SOON_S:
            self._push()

    def end(self) -> None:
        """Close the connection after all queued frames have been sent."""
        self._is_last = True

    def flush(self) -> None:
        """Send as many queued bytes as the client accepts.

        Close the connection if the client has closed it or reads too slowly.
        """
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
        """Send as many queued bytes as possible. Return False if the client has closed the connection."""
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
        """Close the connection. Its programs end like the programs of a closed terminal."""
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
        """Read the bytes that have arrived. Return False if the connection should be closed."""
        try:
            data = self._socket.recv(CHUNK)
            self._received += self._frames.feed(data)
        except BlockingIOError:
            return True
        except (OSError, BadFrame):
            return False
        return bool(data)

    def take_received(self) -> None:
        """Handle the received frames. An invalid frame closes the connection."""
        try:
            while self._received and self.is_open:
                self._take(*self._received.popleft())
        except (BadFrame, ValueError, IndexError):
            self.close()
        except Exception:  # a bug in edulaunch: the machine and its other terminals continue
            traceback.print_exc(file=sys.__stderr__)
            self.close()

    def look_for_signals(self, deliver: Callable[[int], object]) -> None:
        """Deliver Ctrl-C and the end of the terminal to a program of the terminal that does not yield.

        :param deliver: a function that delivers a signal, given its number.
        :raises BaseException: the exception that the signal raises in the middle of the program's code.
        """
        if not self._read():
            self.close()
        for message in [message for message in self._received if message[0] == wire.SIGNAL]:
            self._received.remove(message)
            self._answer()
            deliver(int(message[1]))

    def _answer(self) -> None:
        """Confirm a signal to the client immediately, because a program may run for a long time without yielding."""
        self.send(wire.ANSWER)
        self._push()

    def _take(self, kind: int, payload: bytes) -> None:
        if self.terminal is not None:
            if kind == wire.SIGNAL:
                self._answer()
            self.terminal.take(kind, payload)
            return
        fields = wire.unpack(payload) if kind == wire.HELLO else ['']
        if not hmac.compare_digest(fields[0].encode('utf-8', 'replace'), self._token.encode()):
            raise BadFrame('wrong token')
        self.send(wire.WELCOME)
        self.terminal = self._open_peer(self, fields[1:])


class RemoteInput(PipedInput):
    """The standard input of a client. The client reads its keyboard only after a program of the machine has requested input.

    :param send: a function that sends a frame to the client.
    :param is_terminal: whether the client's input is a terminal. Otherwise, it is a pipe or a file.
    :ivar size: the columns and lines of the terminal.
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
        """Return whether the client's input is a terminal."""
        return self._is_terminal

    def terminal_size(self) -> tuple[int, int]:
        """Return the columns and lines of the client's window."""
        return self.size if self._is_terminal else super().terminal_size()

    def take_due(self) -> None:
        """Request input from the client, because a program reads or checks for input."""
        if not self._is_wanted:
            self._is_wanted = True
            self._send(wire.READ)

    def change_mode(self, process: Process, flags: int) -> None:
        """Make the client's terminal send single keys or whole lines, as the program requests."""
        import termios

        super().change_mode(process, flags)
        signs = ((wire.CANONICAL, termios.ICANON), (wire.ECHO, termios.ECHO), (wire.SIGNALS, termios.ISIG))
        mode = sum(sign for sign, flag in signs if flags & flag)
        if self._is_terminal and mode != self._mode:
            self._mode = mode
            self._send(wire.MODE, str(mode).encode())
