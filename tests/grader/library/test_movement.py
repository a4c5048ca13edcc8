"""Movements are measured from times and positions alone."""

from __future__ import annotations

from edugrade.library.movement import distances, farthest, length

LEADER = [(0.0, 0.0, 0.0), (1.0, 3.0, 4.0), (2.0, 3.0, 4.0)]


def test_length_adds_up_the_steps() -> None:
    assert length(LEADER) == 5.0
    assert length([]) == 0.0


def test_distance_is_to_the_newest_sample_of_the_leader() -> None:
    follower = [(0.5, 0.0, 0.0), (1.0, 0.0, 0.0), (3.0, 3.0, 0.0)]
    assert distances(LEADER, follower) == [(0.5, 0.0), (1.0, 5.0), (3.0, 4.0)]


def test_no_distance_before_the_leader_is_there() -> None:
    assert distances(LEADER, [(-1.0, 0.0, 0.0)]) == []


def test_farthest_looks_only_from_its_time_on() -> None:
    samples = [(0.0, 9.0), (1.0, 1.0), (2.0, 2.0)]
    assert farthest(samples, 1.0) == (2.0, 2.0)
    assert farthest(samples, 5.0) is None
