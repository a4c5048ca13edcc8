"""Which things moved, and where they were."""

from __future__ import annotations

import math
from types import SimpleNamespace
from typing import Any

import pytest

from edulaunch.engine.recording.trajectory import ODOMETRY, POSE, moving_things, read_trajectory
from edulaunch.errors import EdulaunchError


def topic(name: str, kind: str = POSE, publishers: Any = ('n',)) -> Any:
    return SimpleNamespace(name=name, type=kind, publishers=list(publishers))


class Recorded:
    def __init__(self, *topics: Any) -> None:
        self.topics = {one.name: one for one in topics}

    def series(self, name: str, *fields: str) -> list[tuple[float, ...]]:
        if self.topics[name].type == POSE:
            assert fields == ('x', 'y', 'theta')
            return [(0.0, 1.0, 2.0, 3.0), (0.5, 4.0, 5.0, 6.0)]
        assert [field.rpartition('.')[2] for field in fields] == ['x', 'y', 'z', 'w']
        turn = math.radians(60)
        return [(0.0, 1.0, 2.0, math.sin(turn / 2), math.cos(turn / 2))]


def test_what_moves_is_named_after_its_topic() -> None:
    recording: Any = Recorded(
        topic('/turtle1/pose'),
        topic('/a/b/pose'),
        topic('/odom', ODOMETRY),
        topic('/silent/pose', publishers=()),
        topic('/still', ODOMETRY, ()),
        topic('/pose_of'),
        topic('/x/pose', 'std_msgs/msg/String'),
    )
    assert moving_things(recording) == {'turtle1': '/turtle1/pose', '/a/b': '/a/b/pose', '/odom': '/odom'}


@pytest.mark.parametrize('name', ['turtle1', '/turtle1'])
def test_a_turtle_is_read_by_its_name(name: str) -> None:
    recording: Any = Recorded(topic('/turtle1/pose'))
    found = read_trajectory(recording, name)
    assert [list(column) for column in found] == [[0.0, 0.5], [1.0, 4.0], [2.0, 5.0], [3.0, 6.0]]
    assert found.theta is found[3]


@pytest.mark.parametrize('name', ['odom', '/odom'])
def test_the_yaw_of_a_robot_is_read_from_its_quaternion(name: str) -> None:
    recording: Any = Recorded(topic('/odom', ODOMETRY))
    found = read_trajectory(recording, name)
    assert [float(column[0]) for column in found] == pytest.approx([0.0, 1.0, 2.0, math.radians(60)])


def test_what_did_not_move_is_refused_with_what_did() -> None:
    recording: Any = Recorded(topic('/turtle1/pose'))
    with pytest.raises(EdulaunchError, match="nothing called 'turtle2' moved"):
        read_trajectory(recording, 'turtle2')
    empty: Any = Recorded(topic('/turtle1/pose'))
    empty.series = lambda *_: []
    assert [len(column) for column in read_trajectory(empty, 'turtle1')] == [0, 0, 0, 0]
