"""Measures how turtles and robots moved, from what was published about them."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Sequence
from math import hypot
from typing import TYPE_CHECKING, cast

if TYPE_CHECKING:
    from edulaunch.recording import Recording

Track = list[tuple[float, float, float]]  # (time in s, x in m, y in m)


def odometry_track(recording: Recording, topic: str = '/odom') -> Track:
    """Where a robot was, by its odometry; empty when nobody published any."""
    return cast(Track, recording.series(topic, 'pose.pose.position.x', 'pose.pose.position.y'))


def turtle_track(recording: Recording, topic: str) -> Track:
    """Where a turtle was, by its pose topic; empty when nobody published any."""
    return cast(Track, recording.series(topic, 'x', 'y'))


def length(track: Track) -> float:
    """Metres travelled along a track."""
    return sum(hypot(b[1] - a[1], b[2] - a[2]) for a, b in zip(track, track[1:], strict=False))


def distances(leader: Track, follower: Track) -> list[tuple[float, float]]:
    """(time, distance) at each sample of the follower, to the leader's newest sample then."""
    times = [sample[0] for sample in leader]
    found = []
    for time, x, y in follower:
        newest = bisect_right(times, time) - 1
        if newest >= 0:
            found.append((time, hypot(leader[newest][1] - x, leader[newest][2] - y)))
    return found


def farthest(samples: Sequence[tuple[float, float]], since_s: float) -> tuple[float, float] | None:
    """The (time, distance) of the greatest distance from a time on; None without samples there."""
    late = [sample for sample in samples if sample[0] >= since_s]
    return max(late, key=lambda sample: sample[1]) if late else None
