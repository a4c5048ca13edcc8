"""One frame over time: order, cache length, interpolation, parents, and what it costs."""

from __future__ import annotations

from math import atan2, sqrt

import pytest
from hypothesis import given
from hypothesis import strategies as st

from edulaunch.engine.tf.history import COMPACT_AT, History
from edulaunch.engine.tf.quaternions import conjugate, multiply

from .shapes import at, poses


def history_of(*samples: tuple[int, float] | tuple[int, float, str]) -> History:
    history = History('child', static=False)
    for stamp, x, *parent in samples:
        history.insert(parent[0] if parent else 'parent', stamp, at(x))
    return history


@given(st.lists(st.integers(1, 1000), min_size=1, max_size=30))
def test_samples_stand_in_order_of_time_whatever_the_order_of_arrival(stamps):
    history = history_of(*((stamp, float(stamp)) for stamp in stamps))
    assert history.stamps == sorted(set(stamps))


def test_of_equal_stamps_the_last_inserted_wins():
    history = history_of((1, 0.0), (5, 1.0), (5, 2.0), (9, 3.0))
    assert history.pose_at(5)[0] == 2.0
    assert history_of((1, 0.0), (5, 1.0), (5, 2.0)).pose_at(0)[0] == 2.0


def test_among_the_oldest_samples_of_one_stamp_the_first_wins_as_in_tf2():
    assert history_of((1, 0.0), (1, 1.0), (5, 2.0)).pose_at(1)[0] == 0.0


def test_time_zero_is_the_newest_even_beside_a_stamp_of_zero():
    assert history_of((0, 1.0), (5, 2.0)).pose_at(0)[0] == 2.0


def test_an_identical_sample_is_dropped():
    assert history_of((1, 0.0), (5, 1.0), (5, 1.0), (1, 0.0)).count == 2


def test_nothing_is_extrapolated():
    history = history_of((10, 0.0), (20, 1.0))
    assert [history.pose_at(time) for time in (9, 21)] == [None, None]
    assert history_of().pose_at(0) is None


def test_a_single_sample_answers_its_own_stamp_only():
    history = history_of((10, 7.0))
    assert [history.pose_at(time) and history.pose_at(time)[0] for time in (9, 10, 11, 0)] == [None, 7.0, None, 7.0]


@given(st.integers(10, 20))
def test_between_two_samples_the_place_is_on_the_line(time):
    assert history_of((10, 0.0), (20, 1.0)).pose_at(time)[0] == pytest.approx((time - 10) / 10)


def turn(a, b):
    """The angle between two rotations, the shorter way round, in radians."""
    x, y, z, w = multiply(conjugate(a[3:]), b[3:])
    return 2.0 * atan2(sqrt(x * x + y * y + z * z), abs(w))


@given(poses, poses, st.integers(0, 1000))
def test_interpolation_is_a_line_for_the_place_and_slerp_for_the_rotation(a, b, part):
    history = History('child', static=False)
    history.insert('parent', 1000, a)
    history.insert('parent', 2000, b)
    found, ratio = history.pose_at(1000 + part), part / 1000
    for low, value, high in zip(a[:3], found[:3], b[:3], strict=True):
        assert value == pytest.approx(low + ratio * (high - low), abs=1e-9)
        assert min(low, high) - 1e-9 <= value <= max(low, high) + 1e-9
    whole, done = turn(a, b), turn(a, found)
    assert done == pytest.approx(ratio * whole, abs=1e-6)
    assert turn(found, b) == pytest.approx(whole - done, abs=1e-6)


def test_between_different_parents_the_older_sample_holds():
    history = history_of((10, 0.0, 'map'), (20, 1.0, 'odom'), (30, 2.0, 'odom'))
    assert [history.sample(time)[1] for time in (10, 19, 20, 25, 30, 0)] == ['map', 'map', 'odom', 'odom', 'odom', 'odom']
    assert [history.sample(time)[0][0] for time in (19, 25)] == [0.0, 1.5]


def test_a_static_history_answers_any_time():
    history = History('child', static=True)
    history.replace('parent', at(1.0))
    history.replace('parent', at(2.0))
    assert [history.pose_at(time)[0] for time in (0, 5, 10**18)] == [2.0, 2.0, 2.0]
    assert (history.newest, history.oldest, history.count) == (0, 0, 1)


def test_pruning_drops_what_is_older_and_keeps_the_rest():
    history = history_of(*((stamp, float(stamp)) for stamp in range(1, 11)))
    history.prune(4)
    assert (history.oldest, history.count, history.pose_at(3)) == (4, 7, None)


def test_the_lists_stay_short_however_many_samples_pass():
    history = History('child', static=False)
    longest = 0
    for stamp in range(1, 5000):
        history.insert('parent', stamp, at(0.0))
        history.prune(stamp - 10)
        longest = max(longest, len(history.stamps))
    assert longest <= 2 * COMPACT_AT + 12


def test_after_the_old_parent_has_been_pruned_away_all_samples_agree_again():
    history = history_of((1, 0.0, 'map'))
    for stamp in range(2, 200):
        history.insert('odom', stamp, at(0.0))
        history.prune(stamp - 10)
    assert not history.mixed
