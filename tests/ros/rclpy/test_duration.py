"""Durations: how they are made, compared, shown and sent."""

from __future__ import annotations

import operator
from typing import Any

import pytest
from builtin_interfaces.msg import Duration as DurationMessage
from builtin_interfaces.msg import Time as TimeMessage
from hypothesis import given
from hypothesis import strategies as st
from rclpy.duration import Duration, Infinite

lengths = st.integers(-(1 << 62), 1 << 62)


@pytest.mark.parametrize(
    ('given_as', 'nanoseconds'),
    [
        ({}, 0),
        ({'seconds': 1.5}, 1_500_000_000),
        ({'seconds': 1, 'nanoseconds': -1}, 999_999_999),
        ({'nanoseconds': 2.9}, 2),
        ({'seconds': -0.5}, -500_000_000),
        ({'nanoseconds': (1 << 63) - 1}, (1 << 63) - 1),
        ({'nanoseconds': -(1 << 63)}, -(1 << 63)),
    ],
)
def test_seconds_and_nanoseconds_are_added(given_as: dict[str, float], nanoseconds: int) -> None:
    duration = Duration(**given_as)
    assert (duration.nanoseconds, duration.get_c_duration()) == (nanoseconds, nanoseconds)
    assert repr(duration) == f'Duration(nanoseconds={nanoseconds})'


@pytest.mark.parametrize('nanoseconds', [1 << 63, -(1 << 63) - 1])
def test_a_duration_has_64_bits(nanoseconds: int) -> None:
    with pytest.raises(OverflowError, match='too large to store in C duration'):
        Duration(nanoseconds=nanoseconds)


def test_the_longest_one_is_infinite() -> None:
    assert (str(Infinite), str(Duration(nanoseconds=5)), Infinite.nanoseconds) == ('Infinite', '5 nanoseconds', (1 << 63) - 1)


@given(lengths, lengths)
def test_durations_compare_as_their_lengths(first: int, second: int) -> None:
    for other in (second, first):
        for compare in (operator.eq, operator.ne, operator.lt, operator.le, operator.gt, operator.ge):
            assert compare(Duration(nanoseconds=first), Duration(nanoseconds=other)) is compare(first, other)


def test_a_duration_is_no_number_and_no_key() -> None:
    duration: Any = Duration(seconds=1)
    assert (duration == 1_000_000_000, duration != 1_000_000_000) == (False, True)
    for compare in (operator.lt, operator.le, operator.gt, operator.ge):
        with pytest.raises(TypeError, match='not supported between'):
            compare(duration, 1)
    with pytest.raises(TypeError, match='unhashable'):
        hash(duration)


@given(st.integers(-(1 << 31) * 10**9, (1 << 31) * 10**9 - 1))
def test_a_message_has_seconds_and_the_rest(nanoseconds: int) -> None:
    message = Duration(nanoseconds=nanoseconds).to_msg()
    assert (message.sec, message.nanosec) == divmod(nanoseconds, 10**9)
    assert Duration.from_msg(message).nanoseconds == nanoseconds


@pytest.mark.parametrize('wrong', [1.0, TimeMessage(), None])
def test_another_message_is_no_duration(wrong: Any) -> None:
    with pytest.raises(TypeError, match=r'Must pass a builtin_interfaces\.msg\.Duration object'):
        Duration.from_msg(wrong)
    assert Duration.from_msg(DurationMessage(sec=2, nanosec=3)).nanoseconds == 2_000_000_003
