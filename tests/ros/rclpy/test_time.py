"""rclpy.time and rclpy.duration."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st
from rclpy.clock import ClockType
from rclpy.duration import Duration
from rclpy.time import Time

nanoseconds = st.integers(0, (1 << 63) - 1)


def test_a_time_is_shown_with_its_clock() -> None:
    assert repr(Time(nanoseconds=5, clock_type=ClockType.ROS_TIME)) == 'Time(nanoseconds=5, clock_type=ROS_TIME)'


def test_the_default_clock_type_is_system_time() -> None:
    assert Time().clock_type == ClockType.SYSTEM_TIME


@pytest.mark.parametrize(
    ('values', 'error', 'text'),
    [
        ({'seconds': -1}, ValueError, 'Seconds value must not be negative'),
        ({'nanoseconds': -1}, ValueError, 'Nanoseconds value must not be negative'),
        ({'nanoseconds': 1 << 63}, OverflowError, 'Total nanoseconds value is too large to store in C time point.'),
    ],
)
def test_impossible_times_are_refused(values: dict[str, int], error: type[Exception], text: str) -> None:
    with pytest.raises(error) as caught:
        Time(**values)  # type: ignore[arg-type]
    assert str(caught.value) == text


@given(nanoseconds)
def test_a_time_survives_its_message(value: int) -> None:
    value %= (1 << 31) * 10**9
    time = Time(nanoseconds=value, clock_type=ClockType.ROS_TIME)
    assert Time.from_msg(time.to_msg()) == time


@given(nanoseconds, nanoseconds)
def test_the_difference_of_two_times_leads_from_one_to_the_other(first: int, second: int) -> None:
    difference = Time(nanoseconds=second) - Time(nanoseconds=first)
    assert Time(nanoseconds=first) + difference == Time(nanoseconds=second)


def test_times_of_different_clocks_do_not_mix() -> None:
    system, ros = Time(nanoseconds=5), Time(nanoseconds=5, clock_type=ClockType.ROS_TIME)
    with pytest.raises(TypeError, match="Can't compare times with different clock types"):
        assert system < ros
    with pytest.raises(TypeError, match="Can't subtract times with different clock types"):
        assert system - ros


def test_a_time_equals_no_other_object() -> None:
    assert Time(nanoseconds=5) != 5


def test_subtraction_stops_at_zero() -> None:
    with pytest.raises(ValueError, match='Subtraction leads to negative time.'):
        assert Time(seconds=1) - Duration(seconds=2)


def test_from_msg_takes_a_time_message_only() -> None:
    with pytest.raises(TypeError, match='Must pass a builtin_interfaces.msg.Time object'):
        Time.from_msg(3)


def test_durations_are_shown_and_may_be_negative() -> None:
    duration = Duration(seconds=-1.5)
    assert (repr(duration), str(duration)) == ('Duration(nanoseconds=-1500000000)', '-1500000000 nanoseconds')


def test_durations_cannot_be_added_to_each_other() -> None:
    with pytest.raises(TypeError):
        assert Duration(seconds=1) + Duration(seconds=1)  # type: ignore[operator]


@given(st.integers(-(1 << 31) * 10**9, (1 << 31) * 10**9 - 1))
def test_a_duration_survives_its_message(value: int) -> None:
    assert Duration.from_msg(Duration(nanoseconds=value).to_msg()).nanoseconds == value
