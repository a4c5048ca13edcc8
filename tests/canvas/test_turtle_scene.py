"""Turtle windows as data."""

from __future__ import annotations

from typing import Any

import pytest

from edulaunch.canvas.turtle_scene import TurtleScene, turtle_scene
from edulaunch.canvas.worlds import read_worlds

POSE, PEN = 'turtlesim/msg/Pose', 'turtlesim/srv/SetPen'
LIGHT = (179, 184, 255)


def scene_at(recording: Any, time_s: float) -> TurtleScene:
    return turtle_scene(read_worlds(recording), time_s)


def test_a_walking_turtle_stands_at_the_end_of_its_trail(walk: Any) -> None:
    (window,) = scene_at(walk(0.0, 2.0), 1.0).windows
    assert (window.title, window.kind) == ('/sim', 'turtlesim')
    assert [(body.name, body.x, body.y) for body in window.bodies] == [('turtle1', 3.0, 3.0)]
    assert [(trail.colour, trail.width, trail.points) for trail in window.trails] == [(LIGHT, 3, [(2.0, 3.0), (3.0, 3.0)])]


def test_the_caption_says_where_everybody_is(walk: Any) -> None:
    recording = walk(0.5, 2.0)
    assert scene_at(recording, 2.0).caption() == 't=2.000 s: turtle1 at (4.000, 3.000)'
    assert scene_at(recording, 0.1).caption() == 't=0.100 s: empty'


def test_the_first_pose_counts_for_the_moment_before_it(walk: Any) -> None:
    assert scene_at(walk(0.04, 1.0), 0.0).caption() == 't=0.000 s: turtle1 at (2.040, 3.000)'


def test_a_pen_that_is_off_leaves_a_gap(walk: Any, maker: Any) -> None:
    maker.call(0.5, '/turtle1/set_pen', PEN, [0, 0, 0, 0, 1])
    maker.call(1.0, '/turtle1/set_pen', PEN, [255, 0, 0, 5, 0])
    trails = scene_at(walk(0.0, 2.0), 2.0).windows[0].trails
    assert trails == [(LIGHT, 3, [(2.0, 3.0), (2.5, 3.0)]), ((255, 0, 0), 5, [(3.0, 3.0), (4.0, 3.0)])]


def test_clearing_takes_away_what_was_drawn_before(walk: Any, maker: Any) -> None:
    maker.call(1.0, '/clear', 'std_srvs/srv/Empty', [])
    assert scene_at(walk(0.0, 2.0), 2.0).windows[0].trails == [(LIGHT, 3, [(3.0, 3.0), (4.0, 3.0)])]


def test_a_turtle_that_was_killed_is_gone_and_a_new_one_starts_a_new_trail(maker: Any) -> None:
    maker.node('/sim', publishes={'/turtle1/pose': POSE})
    for time_s, x in ((0.0, 1.0), (0.05, 1.1), (1.0, 8.0), (1.05, 8.1)):
        maker.pose(time_s, x, 1.0)
    recording = maker.done(1.05)
    assert scene_at(recording, 0.5).windows[0].bodies == []
    assert [trail.points for trail in scene_at(recording, 1.05).windows[0].trails] == [
        [(1.0, 1.0), (1.1, 1.0)],
        [(8.0, 1.0), (8.1, 1.0)],
    ]


def test_two_worlds_stand_side_by_side_each_with_its_own_turtles(maker: Any) -> None:
    maker.node('/b/sim', publishes={'/b/turtle1/pose': POSE})
    maker.node('/a/sim', publishes={'/a/turtle1/pose': POSE})
    maker.pose(0.0, 1.0, 1.0, turtle='/b/turtle1')
    maker.pose(0.0, 2.0, 2.0, turtle='/a/turtle1')
    scene = scene_at(maker.done(0.05), 0.05)
    assert scene.caption() == 't=0.050 s: /a/sim: turtle1 at (2.000, 2.000), /b/sim: turtle1 at (1.000, 1.000)'


def test_the_ground_has_the_colour_of_the_parameters(maker: Any) -> None:
    maker.node('/sim', publishes={'/turtle1/pose': POSE})
    maker.pose(0.0, 1.0, 1.0)
    maker.parameters += [[0, '/sim', 'background_r', 200, 'default'], [0, '/sim', 'background_g', 0, 'default']]
    assert scene_at(maker.done(0.0), 0.0).windows[0].background == (200, 0, 255)


def test_where_nothing_moved_there_is_nothing_to_draw(maker: Any) -> None:
    with pytest.raises(ValueError, match='nothing moved in this recording'):
        read_worlds(maker.done(1.0))


def two(maker: Any) -> Any:
    maker.node('/sim', publishes={'/turtle1/pose': POSE, '/turtle2/pose': POSE})
    maker.node('/broadcaster', publishes={'/tf': 'tf2_msgs/msg/TFMessage'})
    for number, name in enumerate(('/turtle1', '/turtle2')):
        for tick in range(4):
            maker.pose(tick * 0.05, 1.0 + tick, 1.0 + number, turtle=name)
    maker.frame(0.1, 'world', 'turtle1', 4.0, 1.0)
    maker.frame(0.1, 'turtle1', 'carrot1', 0.0, 2.0)
    return maker.done(0.15)


def test_trails_that_share_a_window_have_their_own_colours_unless_somebody_gave_a_pen(maker: Any) -> None:
    maker.call(0.0, '/turtle2/set_pen', PEN, [1, 2, 3, 4, 0])
    recording = two(maker)
    assert [trail.colour for trail in scene_at(recording, 0.15).windows[0].trails] == [(112, 173, 88), (1, 2, 3)]
    plain = turtle_scene(read_worlds(recording), 0.15, colours=False)
    assert [trail.colour for trail in plain.windows[0].trails] == [LIGHT, (1, 2, 3)]


def test_frames_are_drawn_on_top_on_request(maker: Any) -> None:
    recording = two(maker)
    scene = turtle_scene(read_worlds(recording), 0.15, frames=recording.frames_at(0.15))
    assert [(mark.name, mark.x, mark.y) for mark in scene.windows[0].frames] == [('turtle1', 4.0, 1.0), ('carrot1', 4.0, 3.0)]
    assert recording.plot_turtles(frames=['carrot1']).png().startswith(b'\x89PNG')
    with pytest.raises(KeyError) as caught:
        recording.plot_turtles(frames=['carrott'])
    assert "did you mean 'carrot1'" in str(caught.value.help)  # type: ignore[attr-defined]


ODOM = {'odom': 'nav_msgs/msg/Odometry'}
BOX = '<robot name="r"><link name="b"><visual><geometry><box size="0.4 0.2 0.1"/></geometry></visual></link></robot>'


def robots(maker: Any, *names: str, still: bool) -> Any:
    """Robots that drive along x, each in an odometry frame of its own, which stand still in the map if wanted."""
    from edulaunch.engine.interfaces import current_registry

    wire_type = current_registry().get(ODOM['odom']).wire_type()
    for number, name in enumerate(names):
        maker.node(f'{name}/base', publishes={f'{name}/odom': ODOM['odom'], f'{name}/robot_description': 'std_msgs/msg/String'})
        maker.say(f'{name}/robot_description', 'std_msgs/msg/String', 0.0, [BOX])
        for tick in range(3):
            values = {'pose.pose.position.x': float(tick), 'pose.pose.orientation.w': 1.0, 'header.frame_id': f'{name[1:]}/odom'}
            wire = [values.get(path, [0.0] * 36 if '[' in kind else '' if kind == 'string' else 0) for path, kind in wire_type]
            maker.say(f'{name}/odom', ODOM['odom'], tick * 0.05, wire)
        if still:
            maker.node(f'{name}/still', publishes={'/tf_static': 'tf2_msgs/msg/TFMessage'})
            maker.say(
                '/tf_static',
                'tf2_msgs/msg/TFMessage',
                0.0,
                [[[0, 0, 'map', f'{name[1:]}/odom', 0.0, 2.0 * number, 0.0, 0, 0, 0, 1.0]]],
            )
    return maker.done(0.1)


def test_robots_of_one_map_share_a_field_and_have_their_outlines(maker: Any) -> None:
    (window,) = scene_at(robots(maker, '/a', '/b', still=True), 0.1).windows
    assert window.title == 'robots in map'
    assert [(body.name, body.x, body.y) for body in window.bodies] == [('a', 2.0, 0.0), ('b', 2.0, 2.0)]
    assert [part.kind for part in window.bodies[0].outline] == ['body', 'nose']
    assert max(x for x, _ in window.bodies[0].outline[0].corners) == 0.2


def test_robots_that_nothing_joins_have_a_field_each(maker: Any) -> None:
    recording = robots(maker, '/a', '/b', still=False)
    scene = scene_at(recording, 0.1)
    assert [(window.title, window.bodies[0].name) for window in scene.windows] == [('/a/odom', 'robot'), ('/b/odom', 'robot')]
    assert recording.plot_turtles().png().startswith(b'\x89PNG')
