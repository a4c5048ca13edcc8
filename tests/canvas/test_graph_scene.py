"""The node graph and the tf tree as data."""

from __future__ import annotations

from typing import Any

import pytest

from edulaunch.canvas.graph_scene import GraphScene, graph_scene, tree_scene

POSE, TWIST, SPAWN = 'turtlesim/msg/Pose', 'geometry_msgs/msg/Twist', 'turtlesim/srv/Spawn'


def marks(scene: GraphScene) -> dict[str, str]:
    return {box.name: box.mark for box in scene.boxes if box.mark}


def arrows(scene: GraphScene) -> list[tuple[str, str]]:
    return [(scene.boxes[start].name, scene.boxes[end].name) for start, end in scene.arrows]


def test_the_golden_graph_of_a_driver(maker: Any) -> None:
    maker.node('/sim', publishes={'/turtle1/pose': POSE}, hears={'/turtle1/cmd_vel': TWIST})
    maker.node('/driver', publishes={'/turtle1/cmd_vel': TWIST})
    scene = graph_scene(maker.done(1.0))
    assert [(box.kind, box.name, box.left, box.top) for box in scene.boxes] == [
        ('node', '/sim', 243.0, 19.0),
        ('node', '/driver', 12.0, 19.0),
        ('topic', '/turtle1/cmd_vel', 130.0, 12.0),
    ]
    assert arrows(scene) == [('/driver', '/turtle1/cmd_vel'), ('/turtle1/cmd_vel', '/sim')]
    assert scene.caption() == '2 nodes, 1 topics, 2 connections'


def test_a_topic_that_nobody_publishes_is_marked(walk: Any) -> None:
    scene = graph_scene(walk(0.0, 0.1))
    assert marks(scene) == {'/turtle1/cmd_vel': 'no publisher'}
    assert scene.caption().endswith('; /turtle1/cmd_vel: no publisher')


def test_unused_topics_are_shown_on_request(walk: Any) -> None:
    recording = walk(0.0, 0.1)
    assert '/tf' not in [box.name for box in graph_scene(recording).boxes]
    assert marks(graph_scene(recording, unused=True))['/tf'] == 'no subscriber'


def test_a_node_that_died_is_gone_with_what_it_published(maker: Any) -> None:
    maker.node('/sim', hears={'/turtle1/cmd_vel': TWIST})
    maker.node('/driver', publishes={'/turtle1/cmd_vel': TWIST}, ended=500_000_000)
    scene = graph_scene(maker.done(1.0))
    assert [box.name for box in scene.boxes] == ['/sim', '/turtle1/cmd_vel']
    assert marks(scene) == {'/turtle1/cmd_vel': 'no publisher'}


def test_when_all_have_ended_the_graph_shows_what_there_was(maker: Any) -> None:
    maker.node('/driver', ended=500_000_000)
    assert [box.name for box in graph_scene(maker.done(1.0)).boxes] == ['/driver']


def test_hidden_nodes_stay_hidden(maker: Any) -> None:
    maker.node('/_ros2cli_node', publishes={'/turtle1/cmd_vel': TWIST})
    maker.node('/sim')
    assert [box.name for box in graph_scene(maker.done(1.0)).boxes] == ['/sim']


def test_services_are_shown_on_request_and_marked_without_a_server(maker: Any) -> None:
    maker.node('/sim', serves={'/spawn': SPAWN})
    maker.node('/listener', calls={'/spawn': SPAWN, '/other/spawn': SPAWN})
    recording = maker.done(1.0)
    assert arrows(graph_scene(recording)) == []
    scene = graph_scene(recording, services=True)
    assert arrows(scene) == [('/listener', '/spawn'), ('/spawn', '/sim'), ('/listener', '/other/spawn')]
    assert marks(scene) == {'/other/spawn': 'no server'}


def test_ends_that_cannot_talk_are_marked_unless_the_node_also_hears_with_the_right_type(maker: Any) -> None:
    maker.node('/driver', publishes={'/cmd_vel': TWIST, '/other': TWIST})
    maker.node('/robot', hears={'/cmd_vel': 'geometry_msgs/msg/TwistStamped', '/other': TWIST})
    for topic, kind in (('/cmd_vel', 'geometry_msgs/msg/TwistStamped'), ('/other', 'geometry_msgs/msg/TwistStamped')):
        maker.notes.append(
            [0, 'driver-1', 'incompatible', f'{topic}: /driver ({TWIST}) and /robot ({kind}) cannot talk because of TYPE']
        )
    assert marks(graph_scene(maker.done(1.0))) == {'/cmd_vel': 'type does not fit'}


def test_two_nodes_of_one_name_are_two_and_marked(maker: Any) -> None:
    maker.node('/talker', publishes={'/chatter': 'std_msgs/msg/String'})
    maker.node('/talker', publishes={'/chatter': 'std_msgs/msg/String'})
    maker.node('/listener', hears={'/chatter': 'std_msgs/msg/String'})
    scene = graph_scene(maker.done(1.0))
    assert [(box.name, box.mark) for box in scene.boxes] == [
        ('/talker', 'two nodes have this name'),
        ('/talker', 'two nodes have this name'),
        ('/listener', ''),
        ('/chatter', ''),
    ]
    assert scene.arrows == [(0, 3), (1, 3), (3, 2)]


def test_a_node_that_was_started_again_is_one(maker: Any) -> None:
    maker.node('/talker', ended=500_000_000)
    maker.node('/talker', started=600_000_000, ended=900_000_000)
    assert [(box.name, box.mark) for box in graph_scene(maker.done(1.0)).boxes] == [('/talker', '')]


def test_an_empty_tf_static_is_no_alarm(maker: Any) -> None:
    maker.node('/listener', hears={'/tf_static': 'tf2_msgs/msg/TFMessage', '/tf': 'tf2_msgs/msg/TFMessage'})
    assert marks(graph_scene(maker.done(1.0))) == {'/tf': 'no publisher'}


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
    with pytest.raises(ValueError, match='no node published to /tf or /tf_static'):
        tree_scene(maker.done(1.0))
