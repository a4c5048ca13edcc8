"""The tf2 tutorials' programs (facts_tf2.md, section 11)."""

from __future__ import annotations

from math import hypot
from typing import Any

import pytest
from geometry_msgs.msg import Twist, Vector3
from turtlesim.msg import Pose

from edulaunch.engine.sim.simulation import EPOCH_NS


def transforms(stage: Any, topic: str = '/tf') -> list[Any]:
    return [transform for message in stage.messages(topic) for transform in message.transforms]


def test_broadcaster_sends_one_transform_for_each_pose(stage: Any) -> None:
    stage.start('turtle_tf2_py', 'turtle_tf2_broadcaster', '--ros-args', '-p', 'turtlename:=leo', '-r', '__ns:=/far')
    stage.until(500)
    stage.publish('/leo/pose', Pose(x=1.0, y=2.0, theta=0.5))
    stage.until(501)
    [sent] = transforms(stage)
    assert (sent.header.frame_id, sent.child_frame_id) == ('world', 'leo')
    assert sent.header.stamp.nanosec == 500_000_000
    assert (sent.transform.translation.x, sent.transform.translation.y) == (1.0, 2.0)
    assert (sent.transform.rotation.z, sent.transform.rotation.w) == pytest.approx((0.24740395, 0.96891242))


def test_listener_spawns_then_looks_up_then_drives(stage: Any) -> None:
    stage.start('turtlesim', 'turtlesim_node')
    stage.start('turtle_tf2_py', 'turtle_tf2_listener')
    stage.until(3500)
    texts = [entry for entry in stage.tape.logs if 'turtlesim' not in entry[1]]
    assert texts[1][1].startswith('Spawning turtle [turtle2] at x=[4.000000], y=[2.000000]')
    assert texts[2] == (2000.0, 'Successfully spawned turtle2')
    failure = 'Could not transform turtle2 to turtle1: "turtle2" passed to lookupTransform argument target_frame does not exist. '
    assert texts[3] == (3000.0, failure)


def test_listener_waits_for_the_spawn_service(stage: Any) -> None:
    stage.start('turtle_tf2_py', 'turtle_tf2_listener')
    stage.until(2500)
    assert stage.tape.logs == [(1000.0, 'Service is not ready'), (2000.0, 'Service is not ready')]


def test_turtle2_comes_to_turtle1(stage: Any) -> None:
    stage.start('turtlesim', 'turtlesim_node')
    for name in ('turtle1', 'turtle2'):
        stage.start(
            'turtle_tf2_py',
            'turtle_tf2_broadcaster',
            '--ros-args',
            '-p',
            f'turtlename:={name}',
            '-r',
            f'__node:=broadcaster_{name}',
        )
    stage.start('turtle_tf2_py', 'turtle_tf2_listener')
    stage.until(20_000)
    leader, follower = stage.messages('/turtle1/pose')[-1], stage.messages('/turtle2/pose')[-1]
    assert hypot(leader.x - follower.x, leader.y - follower.y) < 0.2


def test_fixed_carrot_hangs_two_metres_to_the_left(stage: Any) -> None:
    stage.start('turtle_tf2_py', 'fixed_frame_tf2_broadcaster')
    stage.until(1000)
    places = [(sent.transform.translation.x, sent.transform.translation.y) for sent in transforms(stage)]
    assert places == [(0.0, 2.0)] * 10
    frames = {(sent.header.frame_id, sent.child_frame_id) for sent in transforms(stage)}
    assert frames == {('turtle1', 'carrot1')}


def test_dynamic_carrot_flips_every_second(stage: Any) -> None:
    assert EPOCH_NS // 10**9 % 2 == 0
    stage.start('turtle_tf2_py', 'dynamic_frame_tf2_broadcaster')
    stage.until(2950)
    ys = [round(sent.transform.translation.y) for sent in transforms(stage)]
    assert ys == [10] * 9 + [-10] * 10 + [10] * 10
    assert all(abs(sent.transform.translation.x) < 1e-4 for sent in transforms(stage))


def test_static_broadcaster_publishes_its_arguments(stage: Any) -> None:
    stage.start('turtle_tf2_py', 'static_turtle_tf2_broadcaster', 'mystaticturtle', *'00100', '3.14159265')
    stage.until(10)
    [sent] = transforms(stage, '/tf_static')
    assert (sent.header.frame_id, sent.child_frame_id) == ('world', 'mystaticturtle')
    assert sent.transform.translation.z == 1.0
    assert sent.transform.rotation.z == pytest.approx(1.0)


@pytest.mark.parametrize(
    'arguments, code, text',
    [(['a', '1'], 1, 'Invalid number of parameters.'), (['world', *'000000'], 2, 'Your static turtle name cannot be "world"')],
)
def test_static_broadcaster_refuses(stage: Any, arguments: list[str], code: int, text: str) -> None:
    process = stage.start('turtle_tf2_py', 'static_turtle_tf2_broadcaster', *arguments)
    stage.until(10)
    assert process.returncode == code
    assert stage.texts()[0].startswith(text)


def test_message_broadcaster_drives_turtle3_and_sends_its_points(stage: Any) -> None:
    stage.start('turtlesim', 'turtlesim_node')
    stage.start('turtle_tf2_py', 'turtle_tf2_message_broadcaster')
    stage.until(3500)
    assert stage.messages('/turtle3/cmd_vel')[0] == Twist(linear=Vector3(x=1.0), angular=Vector3(z=1.0))
    point, pose = stage.messages('/turtle3/turtle_point_stamped')[-1], stage.messages('/turtle3/pose')[-1]
    assert (point.header.frame_id, point.point.x, point.point.y) == ('world', pose.x, pose.y)
