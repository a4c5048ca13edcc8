"""The replay's data: small, whole numbers, true to the run."""

from __future__ import annotations

import math
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from edulaunch.canvas.replay_data import column, pose_at, replay_data
from edulaunch.canvas.worlds import read_worlds


def data_of(recording: Any) -> dict[str, Any]:
    return replay_data(recording, read_worlds(recording))


def test_the_golden_data_of_a_short_walk(walk: Any) -> None:
    data = data_of(walk(0.0, 0.2))
    (world,) = data['worlds']
    assert (data['rate'], data['samples'], world['title']) == (20, 5, '/sim')
    assert world['lives'] == [
        {
            'name': 'turtle1',
            'number': 0,
            'first': 0,
            'count': 5,
            'x': [2000, 50, 50, 50, 50],
            'y': [3000],
            'a': [0],
            'pens': [[0, 179, 184, 255, 3]],
        }
    ]
    assert [(frame['name'], frame['parent'], frame['first'], frame['count']) for frame in world['frames']] == [
        ('world', '', 0, 5),
        ('turtle1', 'world', 0, 5),
    ]


@given(st.lists(st.floats(-20, 20), min_size=1, max_size=60))
def test_columns_give_back_every_value_to_half_a_millimetre(values: list[float]) -> None:
    found = {'first': 0, 'count': len(values), 'x': column(values), 'y': [0], 'a': [0]}
    for number, value in enumerate(values):
        pose = pose_at(found, number)
        assert pose is not None and abs(pose[0] - value) <= 0.00051


def test_the_samples_are_where_the_turtle_was(demo: Any) -> None:
    track = demo.trajectory('turtle2')
    life = next(life for life in data_of(demo)['worlds'][0]['lives'] if life['name'] == 'turtle2')
    pose = pose_at(life, 100)
    nearest = min(range(len(track.t)), key=lambda row: abs(track.t[row] - 5.0))
    assert pose is not None
    assert math.hypot(pose[0] - track.x[nearest], pose[1] - track.y[nearest]) < 0.05
    assert pose_at(life, 0) is None


def test_a_heading_goes_on_counting_beyond_a_whole_turn(maker: Any) -> None:
    maker.node('/sim', publishes={'/turtle1/pose': 'turtlesim/msg/Pose'})
    for step in range(41):
        maker.pose(step / 20, 5.0, 5.0, math.remainder(step * 0.4, math.tau))
    (life,) = data_of(maker.done(2.0))['worlds'][0]['lives']
    pose = pose_at(life, 40)
    assert pose is not None and pose[2] == pytest.approx(16.0, abs=0.01)


def test_a_teleport_is_not_smoothed(maker: Any) -> None:
    maker.node('/sim', publishes={'/turtle1/pose': 'turtlesim/msg/Pose'})
    for time_s, x in ((0.0, 1.0), (0.04, 1.0), (0.06, 9.0), (0.1, 9.0)):
        maker.pose(time_s, x, 1.0)
    (life,) = data_of(maker.done(0.1))['worlds'][0]['lives']
    assert life['x'] == [1000, 0, 8000]


def test_a_tree_that_belongs_to_no_world_is_left_out(walk: Any, maker: Any) -> None:
    maker.frame(0.0, 'base_link', 'laser', 0.3, 0.0, topic='/tf_static')
    assert [frame['name'] for frame in data_of(walk(0.0, 0.2))['worlds'][0]['frames']] == ['world', 'turtle1']
