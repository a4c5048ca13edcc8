"""Measures how turtles and robots moved, from published messages."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Sequence
from math import hypot, isfinite
from typing import TYPE_CHECKING, cast

from ..evidence import Failure
from .identity import nodes_of
from .launched import refuse_strangers

if TYPE_CHECKING:
    from edulaunch.engine.recording import Recording

SIMULATORS = ('turtlesim', 'turtlebot3_gazebo')
PLACES = ('turtlesim/msg/Pose', 'nav_msgs/msg/Odometry')
COMMANDS = ('geometry_msgs/msg/Twist', 'geometry_msgs/msg/TwistStamped')
STEP_M = 0.001  # error of a step by rounding
Track = list[tuple[float, float, float]]  # (time in s, x in m, y in m)


def odometry_track(recording: Recording, topic: str = '/odom') -> Track:
    """Return the track of a robot from its odometry. Without odometry, the track is empty.

    :raises Failure: if another program publishes the topic, or a position on it is missing or not finite.
    """
    return _track(recording, topic, 'turtlebot3_gazebo', 'pose.pose.position.x', 'pose.pose.position.y')


def turtle_track(recording: Recording, topic: str) -> Track:
    """Return the track of a turtle from its pose topic. Without poses, the track is empty.

    :raises Failure: if another program publishes the topic, or a position on it is missing or not finite.
    """
    return _track(recording, topic, 'turtlesim', 'x', 'y')


def _track(recording: Recording, topic: str, package: str, x: str, y: str) -> Track:
    refuse_strangers(recording, topic, package)
    try:
        track = cast(Track, recording.series(topic, x, y))
        wrong = next((time for time, *place in track if not all(map(isfinite, place))), None)
    except (AttributeError, TypeError):
        raise Failure(
            f'{topic} has messages without a position',
            expected=f'only messages with {x} and {y}',
            seen=f'messages of the type {recording.topics[topic].type}',
            try_=f'publish messages without a position on another topic than {topic}',
        ) from None
    if wrong is not None:
        raise Failure(
            f'a position on {topic} is not a number',
            expected='finite numbers',
            seen=f'nan or inf at {wrong:.2f} s',
            try_='find a velocity or a pose that is nan or inf, such as 0.0 / 0.0 in numpy',
        )
    return track


def command_topics(recording: Recording, place_topic: str) -> set[str]:
    """Return the topics from which a turtle or a robot receives its velocities.

    Remappings can give a turtle any topic. So this function uses the subscriptions of the simulator instead of the usual names.

    :param place_topic: the topic with the position of the turtle or robot.
    """
    found = set()
    for position in [place for package in SIMULATORS for place in nodes_of(recording, package)]:
        node = recording.nodes[position]
        places = [name for name, kind in node.publishers if kind in PLACES]
        commands = [name for name, kind in node.subscriptions if kind in COMMANDS]
        if place_topic in places and len(places) == len(commands):
            found.add(commands[places.index(place_topic)])
    return found


def pushed(recording: Recording, topic: str) -> float:
    """Return how many metres a turtle moved beyond the movement from its own velocity. A teleported turtle has no velocity.

    :param topic: the pose topic of the turtle.
    """
    rows = recording.series(topic, 'x', 'y', 'linear_velocity')
    steps = ((hypot(b[1] - a[1], b[2] - a[2]), abs(b[3]) * (b[0] - a[0])) for a, b in zip(rows, rows[1:], strict=False))
    return sum(way - own for way, own in steps if way > 1.05 * own + STEP_M)


def length(track: Track) -> float:
    """Return the length of a track in metres."""
    return sum(hypot(b[1] - a[1], b[2] - a[2]) for a, b in zip(track, track[1:], strict=False))


def fastest(track: Track) -> float:
    """Return the highest speed between two samples in m/s. Teleporting a turtle gives a very high speed."""
    return max(
        (hypot(b[1] - a[1], b[2] - a[2]) / (b[0] - a[0]) for a, b in zip(track, track[1:], strict=False) if b[0] > a[0]),
        default=0.0,
    )


def since(track: Track, since_s: float) -> Track:
    """Return the part of a track from `since_s` seconds on."""
    return [sample for sample in track if sample[0] >= since_s]


def distances(leader: Track, follower: Track) -> list[tuple[float, float]]:
    """Return (time, distance in metres) for each sample of the follower.

    The distance is measured to the newest sample of the leader at that time.
    """
    return [(b[0], hypot(a[1] - b[1], a[2] - b[2])) for a, b in pairs(leader, follower)]


def pairs(leader: Track, follower: Track) -> list[tuple[tuple[float, float, float], tuple[float, float, float]]]:
    """Return pairs (leader's sample, follower's sample): each sample of the follower with the newest one of the leader at that
    time.
    """
    times = [sample[0] for sample in leader]
    newest = [bisect_right(times, sample[0]) - 1 for sample in follower]
    return [(leader[index], sample) for index, sample in zip(newest, follower, strict=True) if index >= 0]


def progress_towards(leader: Track, follower: Track) -> float:
    """Return the metres that the follower drove towards the leader, minus the metres away from the leader. Sideways movement
    does not count.
    """
    total = 0.0
    joined = pairs(leader, follower)
    for (goal, here), (_, there) in zip(joined, joined[1:], strict=False):
        x, y = goal[1] - here[1], goal[2] - here[2]
        distance = hypot(x, y)
        if distance > 0.0:
            total += ((there[1] - here[1]) * x + (there[2] - here[2]) * y) / distance
    return total


def farthest(samples: Sequence[tuple[float, float]], since_s: float) -> tuple[float, float] | None:
    """Return the sample (time, distance) with the greatest distance from `since_s` on, or None without samples."""
    late = [sample for sample in samples if sample[0] >= since_s]
    return max(late, key=lambda sample: sample[1]) if late else None
