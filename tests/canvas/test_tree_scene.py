"""The tf tree as data."""

from __future__ import annotations

from typing import Any

import pytest

from edulaunch.canvas.tree_scene import tree_scene

TF = 'tf2_msgs/msg/TFMessage'


def test_parents_stand_above_children_with_who_broadcasts_how_often(maker: Any) -> None:
    maker.node('/broadcaster', publishes={'/tf': TF})
    maker.node('/fixed', publishes={'/tf_static': TF})
    for step in range(11):
        maker.frame(step / 10, 'world', 'turtle1', 0.0, 0.0)
    maker.frame(0.0, 'turtle1', 'laser', 0.1, 0.0, topic='/tf_static')
    scene = tree_scene(maker.done(1.0))
    assert scene.caption() == 'turtle1 -> laser (static, by /fixed); world -> turtle1 (10.0 Hz, by /broadcaster)'
    top = {box.name: box.top for box in scene.boxes}
    assert top['world'] < top['turtle1'] < top['laser']


def test_trees_that_are_not_connected_are_called_so(maker: Any) -> None:
    maker.node('/broadcaster', publishes={'/tf': TF})
    maker.frame(0.0, 'world', 'a', 0.0, 0.0)
    maker.frame(0.0, 'base', 'b', 0.0, 0.0)
    assert tree_scene(maker.done(1.0)).caption().endswith('; 2 trees that are not connected: world, base')


def test_a_frame_with_two_parents_is_marked_and_keeps_both_links(maker: Any) -> None:
    maker.node('/broadcaster', publishes={'/tf': TF})
    maker.frame(0.0, 'world', 'a', 0.0, 0.0)
    maker.frame(0.1, 'map', 'a', 0.0, 0.0)
    scene = tree_scene(maker.done(1.0))
    assert {box.name: box.mark for box in scene.boxes} == {'world': '', 'map': '', 'a': '2 parents'}
    assert len(scene.links) == 2


def test_a_loop_is_drawn_rather_than_followed(maker: Any) -> None:
    maker.node('/broadcaster', publishes={'/tf': TF})
    maker.frame(0.0, 'a', 'b', 0.0, 0.0)
    maker.frame(0.0, 'b', 'a', 0.0, 0.0)
    assert [box.name for box in tree_scene(maker.done(1.0)).boxes] == ['a', 'b']


def test_no_frame_no_tree(maker: Any) -> None:
    with pytest.raises(ValueError, match='nobody published to /tf or /tf_static'):
        tree_scene(maker.done(1.0))
