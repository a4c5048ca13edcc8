"""One form of frames for all processes of edulaunch."""

from __future__ import annotations

import pytest

from edulaunch.runtime.framing import BadFrame, Frames, frame


@pytest.mark.parametrize('cut', range(1, 20, 3))
def test_frames_survive_any_cut(cut: int) -> None:
    data = frame(72, b'hello') + frame(0) + frame(255, b'x' * 30 + b'y')
    frames = Frames()
    found = [each for at in range(0, len(data), cut) for each in frames.feed(data[at : at + cut])]
    assert found == [(72, b'hello'), (0, b''), (255, b'x' * 30 + b'y')]


def test_a_frame_is_a_length_a_kind_and_a_payload() -> None:
    assert frame(7, b'abc') == b'\3\0\0\0\7abc'


@pytest.mark.parametrize('bad', [frame(2), frame(1, b'abc')], ids=['unknown kind', 'too long'])
def test_the_frames_before_a_bad_one_are_there(bad: bytes) -> None:
    frames = Frames({1: 2})
    frames.add(frame(1, b'ok') + bad)
    assert frames.take() == (1, b'ok')
    with pytest.raises(BadFrame):
        frames.take()


def test_a_long_payload_is_refused_before_it_arrives() -> None:
    with pytest.raises(BadFrame, match='a frame of kind 1 with 11 bytes'):
        list(Frames(10).feed(frame(1, b'x' * 11)[:5]))


def test_what_is_not_taken_comes_at_the_next_call() -> None:
    frames = Frames()
    assert next(iter(frames.feed(frame(1) + frame(2)))) == (1, b'')
    assert list(frames.feed(frame(3))) == [(2, b''), (3, b'')]
