"""Distance over time as data."""

from __future__ import annotations

from typing import Any

import pytest

from edulaunch.canvas.distance_scene import distance_scene

POSE, TF = 'turtlesim/msg/Pose', 'tf2_msgs/msg/TFMessage'


@pytest.fixture
def chase(maker: Any) -> Any:
    """turtle2 comes nearer to turtle1, which stands, at 1 m/s from 3 m on; a frame stands beside turtle1."""
    maker.node('/sim', publishes={'/turtle1/pose': POSE, '/turtle2/pose': POSE})
    maker.node('/broadcaster', publishes={'/tf': TF})
    for step in range(51):
        maker.pose(step / 20, 5.0, 5.0)
        maker.pose(step / 20, 2.0 + step / 20, 5.0, turtle='/turtle2')
        maker.frame(step / 20, 'world', 'carrot1', 5.0, 6.0)
    return maker.done(2.5)


def test_the_distance_falls_and_closeness_is_dated(chase: Any) -> None:
    scene = distance_scene(chase, 'turtle2', 'turtle1', 1.0)
    assert scene.points[0] == (0.0, 3.0) and scene.points[-1] == (2.5, 0.5)
    assert scene.close_since_s == 2.0
    assert scene.caption() == 'turtle2 to turtle1: 3.000 m at t=0.00 s, 0.500 m at t=2.50 s, at most 1 m from t=2.00 s on'


def test_closeness_that_does_not_last_does_not_count(chase: Any) -> None:
    assert distance_scene(chase, 'turtle1', 'turtle2', 0.2).caption().endswith('not close at the end')


def test_a_tf_frame_can_be_followed_too(chase: Any) -> None:
    assert distance_scene(chase, 'turtle1', 'carrot1', 1.0).points[-1] == (2.5, 1.0)


def test_an_unknown_name_is_answered_with_the_known_ones(chase: Any) -> None:
    with pytest.raises(
        KeyError, match="nothing called 'turtle3' moved in this recording; there are: turtle1, turtle2, world, carrot1"
    ):
        distance_scene(chase, 'turtle3', 'turtle1', 1.0)


def test_things_that_never_met_have_no_distance(maker: Any) -> None:
    maker.node('/sim', publishes={'/turtle1/pose': POSE, '/turtle2/pose': POSE})
    maker.pose(0.0, 1.0, 1.0)
    maker.pose(5.0, 1.0, 1.0, turtle='/turtle2')
    with pytest.raises(ValueError, match="'turtle1' and 'turtle2' were never there at the same time"):
        distance_scene(maker.done(6.0), 'turtle1', 'turtle2', 1.0)
