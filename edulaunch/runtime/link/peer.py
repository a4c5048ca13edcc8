"""One end of the link: it sends and receives frames, passes the token, and makes calls."""

from __future__ import annotations

import socket
from collections.abc import Callable
from struct import Struct
from typing import Any, NoReturn

from edulaunch.runtime.framing import BadFrame, Frames, frame
from edulaunch.runtime.link.clock import BEFORE_ALL, Key, PeerSimulation
from edulaunch.runtime.link.codec import LONGEST_FRAME, FrameKind, Violation, dump, load

FLUSH_BYTES = 1 << 17
CHUNK_BYTES = 1 << 18
LAST_NUMBER = 1 << 62
TIME = Struct('<q')
NUMBER = Struct('<Q')
TOKEN = Struct('<QQqBQ')  # number, then a key
Handler = Callable[[memoryview], Any]


class Gone(Exception):
    """The other peer has closed its end of the link."""


class Peer:
    """One peer's end of the link.

    :param trusts: whether the other peer is trusted. If not, its time and numbers must increase, and must stay within its turn.
    :param quota: the maximum number of bytes that the other peer may send; None means no limit.
    """

    def __init__(self, sim: PeerSimulation, end: socket.socket, *, trusts: bool, quota: int | None = None) -> None:
        self.sim = sim
        self.handlers: dict[int, Handler] = {}
        self.calls: dict[int, Handler] = {}
        self.received = 0
        self._end = end
        self._trusts = trusts
        self._quota = quota
        self._out = bytearray()
        self._in = Frames(LONGEST_FRAME)
        self._sent_ns = sim.now_ns
        self._grant_ns = sim.now_ns
        sim.pass_token = self._pass_token

    def fatal(self, error: Exception) -> NoReturn:
        """React to a failed link. Programs can catch exceptions, so the owner of this peer may end the process here."""
        raise error

    def send(self, kind: FrameKind, payload: bytes) -> None:
        """Send a frame that wakes no task of the other peer, such as a frame for the recording."""
        if self._sent_ns != self.sim.now_ns:
            self._sent_ns = self.sim.now_ns
            self._add(FrameKind.ADVANCE, TIME.pack(self._sent_ns))
        self._add(kind, payload)

    def tell(self, kind: FrameKind, payload: bytes) -> None:
        """Send a frame that may wake tasks of the other peer. The frame keeps its position among the items that this peer
        schedules.
        """
        sim = self.sim
        if self._marked != sim.last_number or not sim.is_marked():
            self.send(FrameKind.MARK, NUMBER.pack(sim.number_for_the_other()))
            self._marked = sim.last_number
        self.send(kind, payload)

    _marked = -1

    def call(self, kind: FrameKind, value: Any) -> Any:
        """Make the other peer handle a frame immediately, and return the result."""
        self.send(kind, NUMBER.pack(self.sim.sequence()) + dump(value))
        self._flush()
        return self._take_until(FrameKind.RETURN)

    def _answer(self, kind: int, payload: memoryview) -> None:
        self._continue(payload)
        value = self.calls[kind](payload[NUMBER.size :])
        self._hand_over(FrameKind.RETURN, self.sim.head(), dump(value))

    def _hand_over(self, kind: FrameKind, key: Key, value: bytes = b'null') -> None:
        self.send(kind, TOKEN.pack(self.sim.sequence(), *key) + value)
        self._flush()

    def _pass_token(self, key: Key) -> None:
        self._hand_over(FrameKind.TOKEN, key)
        self.await_token(key[0] if key[1] != BEFORE_ALL else key[0] - 1)

    def await_token(self, grant_ns: int) -> None:
        """Let the other peer run until it passes the token, but not beyond the time `grant_ns`."""
        self._grant_ns = grant_ns
        self._take_until(FrameKind.TOKEN)
        self._grant_ns = self.sim.now_ns

    def _take_until(self, kind: FrameKind) -> Any:
        """Receive frames until a frame of this kind arrives. Return the value in that frame."""
        return self.checked(lambda: self._until(kind))

    def _until(self, kind: FrameKind) -> Any:
        while True:
            found, payload = self._next()
            if found == kind:
                return self._take_over(payload)
            self._dispatch(found, payload)

    def checked(self, act: Callable[[], Any]) -> Any:
        """Run code that handles a frame of the other peer. An error in it ends the link."""
        try:
            return act()
        except (Violation, Gone, TooMuch, TooManyPrograms) as error:
            self.fatal(error)
        except Exception as error:
            if self._trusts:
                raise
            self.fatal(error)

    def _take_over(self, payload: memoryview) -> Any:
        """Store the last sequence number of the other peer and the key of its next item. Return the value in the frame."""
        number, *key = TOKEN.unpack_from(payload)
        self._take_number(number)
        self.sim.other = key[0], key[1], key[2], key[3]
        return load(bytes(payload[TOKEN.size :]))

    def _continue(self, payload: memoryview) -> None:
        self._take_number(NUMBER.unpack_from(payload)[0])

    def _take_number(self, number: int) -> None:
        if not self._trusts and not self.sim.sequence() <= number < LAST_NUMBER:
            raise Violation('numbers must increase')
        self.sim.continue_from(number)

    def advance(self, payload: memoryview) -> None:
        """Set the clock to the time of the other peer."""
        (now_ns,) = TIME.unpack(payload)
        if not self._trusts and not self.sim.now_ns <= now_ns <= self._grant_ns:
            raise Violation('time must increase, and not pass the next item of the other peer')
        self._sent_ns = self.sim.now_ns = now_ns

    def _add(self, kind: FrameKind, payload: bytes) -> None:
        self._out += frame(kind, payload)
        if len(self._out) > FLUSH_BYTES:
            self._flush()

    def _flush(self) -> None:
        data, self._out = self._out, bytearray()
        try:
            self._end.sendall(data)
        except OSError:
            self.fatal(Gone())

    def _dispatch(self, kind: int, payload: memoryview) -> None:
        if kind == FrameKind.ADVANCE:
            self.advance(payload)
        elif kind == FrameKind.MARK:
            self._continue(payload)
        elif kind in self.calls:
            self._answer(kind, payload)
        else:
            self.handlers[kind](payload)

    def _next(self) -> tuple[int, memoryview]:
        try:
            while (found := self._in.take()) is None:
                self._read()
        except BadFrame as error:
            raise Violation(str(error)) from None
        return found[0], memoryview(found[1])

    def _read(self) -> None:
        try:
            data = self._end.recv(CHUNK_BYTES)
        except OSError:
            raise Gone from None
        if not data:
            raise Gone
        self.received += len(data)
        if self._quota is not None and self.received > self._quota:
            raise TooMuch
        self._in.add(data)


class TooMuch(Exception):
    """The other peer has sent more than its quota."""


class TooManyPrograms(Exception):
    """The other peer has started more programs than a run may have."""
