"""What a peer sends, accepts and refuses, frame by frame."""

from __future__ import annotations

import socket
from collections.abc import Iterator
from typing import Any

import pytest

from edulaunch.engine.sim.simulation import EPOCH_NS
from edulaunch.runtime.framing import Frames, frame
from edulaunch.runtime.link.clock import BEFORE_ALL, FOR_THE_OTHER, NEVER, PeerSimulation
from edulaunch.runtime.link.codec import FrameKind, Violation
from edulaunch.runtime.link.peer import FLUSH_BYTES, LAST_NUMBER, NUMBER, TIME, TOKEN, Gone, Peer, TooMuch


class Pair:
    """A peer, and the bare end of a socket in place of the other one."""

    def __init__(self, ends: tuple[socket.socket, socket.socket], *, trusts: bool, quota: int | None = None) -> None:
        self.sim, self.end, self.frames = PeerSimulation(), ends[1], Frames()
        self.peer = Peer(self.sim, ends[0], trusts=trusts, quota=quota)

    def sent(self) -> list[tuple[int, bytes]]:
        self.end.setblocking(False)
        try:
            return list(self.frames.feed(self.end.recv(1 << 20)))
        except BlockingIOError:
            return []

    def answer(self, *frames: bytes) -> None:
        self.end.sendall(b''.join(frames))


@pytest.fixture
def ends() -> Iterator[tuple[socket.socket, socket.socket]]:
    pair = socket.socketpair()
    yield pair
    for end in pair:
        end.close()


def handed(kind: FrameKind, number: int = 0, value: bytes = b'null', key: tuple[int, ...] = NEVER) -> bytes:
    return frame(kind, TOKEN.pack(number, *key) + value)


def test_frames_wait_for_a_call_and_the_time_is_sent_once_for_each_instant(ends: Any) -> None:
    pair = Pair(ends, trusts=True)
    pair.peer.send(FrameKind.NOTE, b'a')
    pair.sim.now_ns += 5
    pair.peer.send(FrameKind.NOTE, b'b')
    pair.peer.send(FrameKind.NOTE, b'c')
    assert pair.sent() == []
    pair.answer(handed(FrameKind.RETURN, 7, b'[1]', (EPOCH_NS + 9, 2, 0, 3)))
    assert pair.peer.call(FrameKind.REQUEST, {'x': 1}) == [1]
    time = (FrameKind.ADVANCE, TIME.pack(EPOCH_NS + 5))
    asked = (FrameKind.REQUEST, NUMBER.pack(0) + b'{"x":1}')
    assert pair.sent() == [(FrameKind.NOTE, b'a'), time, (FrameKind.NOTE, b'b'), (FrameKind.NOTE, b'c'), asked]
    assert (pair.sim.sequence(), pair.sim.other) == (8, (EPOCH_NS + 9, 2, 0, 3))


def test_one_mark_goes_before_what_wakes_tasks_until_something_is_scheduled_here(ends: Any) -> None:
    pair = Pair(ends, trusts=True)
    pair.peer.tell(FrameKind.READY, b'a')
    pair.peer.tell(FrameKind.READY, b'b')
    pair.sim.schedule(pair.sim.now_ns, lambda: None)
    pair.peer.tell(FrameKind.READY, b'c')
    pair.peer.send(FrameKind.NOTE, b'x' * FLUSH_BYTES)
    found = [(kind, NUMBER.unpack(data)[0] if kind == FrameKind.MARK else data[:1]) for kind, data in pair.sent()]
    first = [(FrameKind.MARK, 1), (FrameKind.READY, b'a'), (FrameKind.READY, b'b')]
    then = [(FrameKind.MARK, 4 + FOR_THE_OTHER), (FrameKind.READY, b'c'), (FrameKind.NOTE, b'x')]
    assert found == [*first, *then]


def test_much_is_sent_without_a_call(ends: Any) -> None:
    pair = Pair(ends, trusts=True)
    pair.peer.send(FrameKind.NOTE, b'x' * (FLUSH_BYTES - 5))
    assert pair.sent() == []
    pair.peer.send(FrameKind.NOTE, b'')
    assert [kind for kind, _ in pair.sent()] == [FrameKind.NOTE, FrameKind.NOTE]


def test_a_call_is_answered_with_the_key_of_the_next_item(ends: Any) -> None:
    pair = Pair(ends, trusts=True)
    pair.peer.calls[FrameKind.OUTPUT] = lambda payload: {'got': bytes(payload).decode()}
    pair.sim.schedule(EPOCH_NS + 40, lambda: None)
    heard: list[bytes] = []
    pair.peer.handlers[FrameKind.NOTE] = lambda payload: heard.append(bytes(payload))
    pair.answer(frame(FrameKind.NOTE, b'n'), frame(FrameKind.OUTPUT, NUMBER.pack(9) + b'hello'), handed(FrameKind.TOKEN, 11))
    pair.peer.await_token(EPOCH_NS)
    ((kind, data),) = pair.sent()
    assert (kind, data[TOKEN.size :], heard) == (FrameKind.RETURN, b'{"got":"hello"}', [b'n'])
    assert TOKEN.unpack_from(data)[:3] == (10, EPOCH_NS + 40, 0)
    assert pair.sim.sequence() == 12


def test_the_other_side_may_run_until_the_key_that_it_gets(ends: Any) -> None:
    for priority, most in ((0, 7), (BEFORE_ALL, 6)):
        pair = Pair(ends, trusts=False)
        pair.answer(frame(FrameKind.ADVANCE, TIME.pack(EPOCH_NS + most)), handed(FrameKind.TOKEN))
        pair.sim.pass_token((EPOCH_NS + 7, priority, 0, 1))
        assert pair.sim.now_ns == EPOCH_NS + most
        assert [kind for kind, _ in pair.sent()] == [FrameKind.TOKEN]
        pair = Pair(ends, trusts=False)
        pair.answer(frame(FrameKind.ADVANCE, TIME.pack(EPOCH_NS + most + 1)))
        with pytest.raises(Violation, match='time must increase'):
            pair.sim.pass_token((EPOCH_NS + 7, priority, 0, 1))
        pair.sent()


@pytest.mark.parametrize(('number', 'is_right'), [(5, False), (6, True), (LAST_NUMBER - 1, True), (LAST_NUMBER, False)])
@pytest.mark.parametrize('trusts', [True, False])
def test_numbers_of_who_is_not_trusted_increase_to_a_bound(ends: Any, number: int, is_right: bool, trusts: bool) -> None:
    pair = Pair(ends, trusts=trusts)
    pair.answer(frame(FrameKind.MARK, NUMBER.pack(5)), handed(FrameKind.TOKEN, number))
    if is_right or trusts:
        pair.peer.await_token(EPOCH_NS)
        assert pair.sim.sequence() == number + 1
    else:
        with pytest.raises(Violation, match='numbers must increase'):
            pair.peer.await_token(EPOCH_NS)


@pytest.mark.parametrize(('offset', 'is_right'), [(-1, False), (0, True), (3, True), (4, False)])
@pytest.mark.parametrize('trusts', [True, False])
def test_the_time_of_who_is_not_trusted_stays_in_its_turn(ends: Any, offset: int, is_right: bool, trusts: bool) -> None:
    pair = Pair(ends, trusts=trusts)
    pair.answer(frame(FrameKind.ADVANCE, TIME.pack(EPOCH_NS + offset)), handed(FrameKind.TOKEN))
    if is_right or trusts:
        pair.peer.await_token(EPOCH_NS + 3)
        assert pair.sim.now_ns == EPOCH_NS + offset
        pair.peer.send(FrameKind.NOTE, b'x' * FLUSH_BYTES)
        assert [kind for kind, _ in pair.sent()] == [FrameKind.NOTE]  # the other side knows this time
    else:
        with pytest.raises(Violation):
            pair.peer.await_token(EPOCH_NS + 3)


def test_time_stays_where_it_is_outside_a_turn(ends: Any) -> None:
    pair = Pair(ends, trusts=False)
    pair.answer(handed(FrameKind.TOKEN), frame(FrameKind.ADVANCE, TIME.pack(EPOCH_NS + 1)), handed(FrameKind.RETURN))
    pair.peer.await_token(EPOCH_NS + 3)
    with pytest.raises(Violation, match='time must increase'):
        pair.peer.call(FrameKind.REQUEST, None)


@pytest.mark.parametrize('trusts', [True, False])
def test_a_fault_in_handling_a_frame_is_the_links_only_for_who_is_not_trusted(ends: Any, trusts: bool) -> None:
    pair = Pair(ends, trusts=trusts)
    pair.answer(frame(250, b''))
    ended: list[Exception] = []
    pair.peer.fatal = ended.append  # type: ignore[assignment,method-assign]
    if trusts:
        with pytest.raises(KeyError):
            pair.peer.await_token(EPOCH_NS)
    else:
        pair.peer.await_token(EPOCH_NS)
    assert [type(error) for error in ended] == ([] if trusts else [KeyError])


@pytest.mark.parametrize(('quota', 'is_right'), [(None, True), (100, True), (len(handed(FrameKind.TOKEN)), True), (20, False)])
def test_a_quota_counts_every_byte(ends: Any, quota: int | None, is_right: bool) -> None:
    pair = Pair(ends, trusts=True, quota=quota)
    pair.answer(handed(FrameKind.TOKEN))
    if is_right:
        pair.peer.await_token(EPOCH_NS)
        assert pair.peer.received == len(handed(FrameKind.TOKEN))
    else:
        with pytest.raises(TooMuch):
            pair.peer.await_token(EPOCH_NS)


def test_an_end_that_is_closed_is_gone(ends: Any) -> None:
    pair = Pair(ends, trusts=True)
    pair.end.close()
    with pytest.raises(Gone):
        pair.peer.send(FrameKind.NOTE, b'x' * FLUSH_BYTES)
    with pytest.raises(Gone):
        pair.peer.await_token(EPOCH_NS)
    with pytest.raises(Gone):
        pair.peer.call(FrameKind.REQUEST, None)


def test_a_frame_that_is_too_long_breaks_the_rules(ends: Any) -> None:
    pair = Pair(ends, trusts=True)
    pair.answer((1 << 31).to_bytes(4, 'little') + b'\x00')
    with pytest.raises(Violation, match='a frame of kind 0'):
        pair.peer.await_token(EPOCH_NS)
