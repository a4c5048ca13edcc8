"""Frames between a link and its side process, and the order in which they go out."""

from __future__ import annotations

import pytest

from edulaunch.extras.network.rclpy_wire import CHUNK, Outbox, frame, opened
from edulaunch.runtime.framing import Frames


class Narrow:
    """A socket that takes some bytes, then no more."""

    def __init__(self, room: int) -> None:
        self.room, self.got = room, b''

    def write(self, data: memoryview) -> int:
        taken = data[: self.room]
        if not len(taken):
            raise BlockingIOError
        self.room -= len(taken)
        self.got += taken
        return len(taken)


def test_what_is_urgent_goes_out_behind_the_frame_that_is_half_sent() -> None:
    box, narrow = Outbox(), Narrow(5)
    for letter in (b'a', b'b', b'c'):
        box.put(letter * CHUNK)
    with pytest.raises(BlockingIOError):
        box.send(narrow.write)
    box.put(b'new', is_urgent=True)
    narrow.room = 4 * CHUNK
    box.send(narrow.write)
    assert narrow.got == b'a' * CHUNK + b'new' + b'b' * CHUNK + b'c' * CHUNK
    assert box.size == 0


def test_small_frames_are_sent_together() -> None:
    box, calls = Outbox(), list[bytes]()
    for number in range(1000):
        box.put(frame(1, number))
    box.send(lambda data: calls.append(bytes(data)) or len(data))  # type: ignore[func-returns-value]
    assert len(calls) == 1 and [handle for _, handle, _, _ in opened(Frames().feed(calls[0]))] == list(range(1000))


def test_a_cleared_box_is_empty() -> None:
    box, narrow = Outbox(), Narrow(1)
    box.put(b'ab')
    with pytest.raises(BlockingIOError):
        box.send(narrow.write)
    box.clear()
    box.send(narrow.write)
    assert (box.size, narrow.got) == (0, b'a')


@pytest.mark.parametrize('cut', range(1, 40, 7))
def test_frames_survive_any_cut(cut: int) -> None:
    data = frame(4, 1, -2, b'hello') + frame(2, 7) + frame(0, 2, 3, b'x' * 30)
    frames = Frames()
    found = [each for at in range(0, len(data), cut) for each in opened(frames.feed(data[at : at + cut]))]
    assert found == [(4, 1, -2, b'hello'), (2, 7, 0, b''), (0, 2, 3, b'x' * 30)]
