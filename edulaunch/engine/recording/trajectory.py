"""The position of a turtle or a robot over time."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

from edulaunch.engine.recording.absent import not_recorded
from edulaunch.engine.recording.messages import Messages

POSE, ODOMETRY = 'turtlesim/msg/Pose', 'nav_msgs/msg/Odometry'


class Trajectory(NamedTuple):
    """The path of a turtle or robot, as arrays of equal length.

    `t` is the time in seconds. `x` (right) and `y` (up) are in metres. `theta` is the heading in radians, counter-clockwise.
    """

    t: Any
    x: Any
    y: Any
    theta: Any


def moving_things(recording: Messages) -> dict[str, str]:
    """Return the topic of each turtle and robot of a recording, by name. The turtles come first.

    Names are such as 'turtle1', '/turtlesim2/turtle1' and '/odom'.
    """
    found = {}
    for topic in recording.topics.values():
        if topic.type == POSE and topic.publishers and topic.name.endswith('/pose'):
            name = topic.name.removesuffix('/pose')
            found[name.removeprefix('/') if name.count('/') == 1 else name] = topic.name
    for topic in recording.topics.values():
        if topic.type == ODOMETRY and topic.publishers:
            found[topic.name] = topic.name
    return found


def read_trajectory(recording: Messages, name: str) -> Trajectory:
    """Return the path of a turtle or robot for `Recording.trajectory`."""
    import numpy as np

    things = moving_things(recording)
    topic = things.get(name) or things.get(name.removeprefix('/')) or things.get('/' + name)
    if topic is None:
        raise not_recorded(f'nothing called {name!r} moved', name, things)
    if recording.topics[topic].type == POSE:
        rows = recording.series(topic, 'x', 'y', 'theta')
    else:
        place = 'pose.pose.position.{}'.format
        turn = 'pose.pose.orientation.{}'.format
        rows = [
            (t, x, y, 2.0 * math.atan2(z, w))
            for t, x, y, z, w in recording.series(topic, place('x'), place('y'), turn('z'), turn('w'))
        ]
    table = np.array(rows, dtype=float).reshape(-1, 4)
    return Trajectory(*(table[:, column] for column in range(4)))
