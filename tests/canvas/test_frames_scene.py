"""tf frames in their root, and as they are seen from above, as data."""

from __future__ import annotations

import math
from typing import Any

import pytest

from edulaunch.canvas.frames_scene import frames_scene, heading, placed
from edulaunch.engine.recording.records import Frame

TF = {'/tf': 'tf2_msgs/msg/TFMessage'}


def test_the_golden_scene_of_a_carrot(maker: Any) -> None:
    maker.node('/broadcaster', publishes=TF)
    maker.frame(0.5, 'world', 'turtle1', 4.0, 2.0, math.pi / 2)
    maker.frame(0.5, 'turtle1', 'carrot1', 2.0, 0.0)
    (view,) = frames_scene(maker.done(1.0), 1.0).views
    assert view.root == 'world'
    assert [(mark.name, mark.parent, round(mark.x, 6), round(mark.y, 6)) for mark in view.frames] == [
        ('world', '', 0.0, 0.0),
        ('turtle1', 'world', 4.0, 2.0),
        ('carrot1', 'turtle1', 4.0, 4.0),
    ]
    assert view.frames[2].x_axis == pytest.approx((0.0, 1.0)) and view.frames[2].y_axis == pytest.approx((-1.0, 0.0))
    assert view.limits == (-1.0, 5.0, -1.0, 5.0)


def test_the_caption_says_where_each_frame_is_in_its_root(maker: Any) -> None:
    maker.node('/broadcaster', publishes=TF)
    maker.frame(0.5, 'world', 'turtle1', 4.0, 2.0)
    maker.frame(0.5, 'base_link', 'laser', 0.3, 0.0)
    assert frames_scene(maker.done(1.0), 1.0).caption() == (
        't=1.000 s: in world: turtle1 at (4.000, 2.000); in base_link: laser at (0.300, 0.000)'
    )


def test_before_the_first_broadcast_the_error_says_who_will(maker: Any) -> None:
    maker.node('/broadcaster', publishes=TF)
    maker.frame(0.5, 'world', 'turtle1', 4.0, 2.0)
    with pytest.raises(ValueError) as caught:
        frames_scene(maker.done(1.0), 0.25)
    assert str(caught.value) == (
        'no tf frame had been broadcast at t = 0.250 s; broadcasters: /broadcaster, the first of them at t = 0.500 s'
    )


def test_without_any_broadcaster_the_error_says_so(maker: Any) -> None:
    with pytest.raises(ValueError, match='no node is a tf broadcaster'):
        frames_scene(maker.done(1.0), 1.0)


def test_from_a_side_the_height_of_a_lidar_is_seen(maker: Any) -> None:
    maker.node('/broadcaster', publishes=TF)
    maker.say('/tf', TF['/tf'], 0.5, [[[0, 0, 'base_link', 'laser', 0.1, 0.2, 0.3, 0.0, 0.0, 0.0, 1.0]]])
    recording = maker.done(1.0)
    for side, place, axes in (
        ('xy', (0.1, 0.2, 0.3), ((1, 0), (0, 1), (0, 0))),
        ('xz', (0.1, 0.3, 0.2), ((1, 0), (0, 0), (0, 1))),
        ('yz', (0.2, 0.3, 0.1), ((0, 0), (1, 0), (0, 1))),
    ):
        scene = frames_scene(recording, 1.0, side)
        laser = scene.views[0].frames[1]
        assert (laser.x, laser.y, laser.z) == place
        assert (laser.x_axis, laser.y_axis, laser.z_axis) == axes
    assert scene.caption() == 't=1.000 s: seen from the side, y and z: in base_link: laser at (0.200, 0.300)'
    with pytest.raises(ValueError, match="unknown side 'xzy'") as caught:
        frames_scene(recording, 1.0, 'xzy')
    assert "did you mean 'xz'" in caught.value.help  # type: ignore[attr-defined]


def turned(yaw: float) -> tuple[float, float, float, float]:
    return (0.0, 0.0, math.sin(yaw / 2), math.cos(yaw / 2))


def frame(parent: str, x: float, y: float, yaw: float = 0.0) -> Frame:
    return Frame(parent, (x, y, 0.0), turned(yaw), False, 0.0)


def test_a_chain_of_frames_is_composed_into_its_root() -> None:
    found = placed({'carrot1': frame('turtle1', 0.0, 2.0), 'turtle1': frame('world', 5.0, 5.0, math.pi / 2)})
    assert list(found) == ['world', 'turtle1', 'carrot1']
    assert found['carrot1'].root == 'world'
    assert found['carrot1'].position == pytest.approx((3.0, 5.0, 0.0))
    assert heading(found['carrot1'].turn) == pytest.approx(math.pi / 2)


def test_trees_that_are_not_connected_keep_roots_of_their_own() -> None:
    found = placed({'a': frame('world', 1, 0), 'b': frame('base', 1, 0)})
    assert {name: place.root for name, place in found.items()} == {'world': 'world', 'base': 'base', 'a': 'world', 'b': 'base'}


def test_a_loop_of_parents_does_not_run_for_ever() -> None:
    found = placed({'a': frame('b', 1, 0), 'b': frame('a', 1, 0)})
    assert sorted(found) == ['a', 'b'] and len({place.root for place in found.values()}) == 1
