"""The Waffle and the node that drives it in circles."""

from __future__ import annotations

from math import hypot
from pathlib import Path
from typing import Any

import pytest
from geometry_msgs.msg import Twist, TwistStamped, Vector3

import edulaunch

LAUNCH = """from launch import LaunchDescription
from launch.actions import ExecuteProcess, TimerAction
from launch_ros.actions import Node


def generate_launch_description():
    send = ['ros2', 'topic', 'pub', '--once', '/cmd_vel', 'geometry_msgs/msg/Twist', '{linear: {x: 0.1}}']
    return LaunchDescription([
        Node(package='turtlebot3_gazebo', executable='waffle_simulator'),
        ExecuteProcess(cmd=['ros2', 'topic', 'type', '/cmd_vel'], output='screen'),
        TimerAction(period=2.0, actions=[ExecuteProcess(cmd=send, output='screen')]),
    ])
"""


def position(message: Any) -> tuple[float, float]:
    return message.pose.pose.position.x, message.pose.pose.position.y


def test_odometry_starts_at_the_spawn_pose_and_comes_30_times_a_second(stage: Any) -> None:
    stage.start('turtlebot3_gazebo', 'waffle_simulator', '--ros-args', '-p', 'x_pose:=1.0', '-p', 'y_pose:=0.5')
    stage.until(1000)
    odometry = stage.messages('/odom')
    assert (len(odometry), position(odometry[0])) == (30, (1.0, 0.5))
    assert (odometry[0].header.frame_id, odometry[0].child_frame_id) == ('odom', 'base_footprint')
    frames = [message.transforms[0].child_frame_id for message in stage.messages('/tf')]
    assert frames == ['base_footprint'] * 30


@pytest.mark.parametrize(
    'message, warnings', [(TwistStamped(twist=Twist(linear=Vector3(x=0.1))), 0), (Twist(linear=Vector3(x=0.1)), 1)]
)
def test_both_kinds_of_twist_drive_it_and_are_kept(stage: Any, message: Any, warnings: int) -> None:
    stage.start('turtlebot3_gazebo', 'waffle_simulator')
    stage.until(500)
    stage.publish('/cmd_vel', message)
    stage.until(600)
    stage.publish('/cmd_vel', message)
    stage.until(10_700)
    assert position(stage.messages('/odom')[-1])[0] == pytest.approx(1.015, abs=0.008)
    assert len(stage.texts()) == 1 + warnings


def test_cmd_vel_has_one_type_until_a_program_publishes_the_other(tmp_path: Path) -> None:
    (tmp_path / 'main.launch.py').write_text(LAUNCH)
    recording = edulaunch.run(tmp_path / 'main.launch.py', duration_s=8.0, console=lambda *_: None)
    shown = [row.text for row in recording.output if row.process == 'ros2-2']
    assert ''.join(shown) == 'geometry_msgs/msg/TwistStamped\n'
    assert position(recording.messages('/odom')[-1][1])[0] > 0.2, 'the only message of `--once` arrives'


def test_param_circle_drives_a_circle_of_its_radius(stage: Any) -> None:
    stage.start('turtlebot3_gazebo', 'waffle_simulator')
    stage.start('part3_beyond_basics', 'param_circle.py', '--ros-args', '-p', 'radius:=0.5')
    stage.until(30_000)
    distances = [hypot(x, y - 0.5) for x, y in map(position, stage.messages('/odom'))]
    assert (min(distances), max(distances)) == pytest.approx((0.5, 0.5), abs=0.02)
    assert stage.texts().count('Moving with radius: 0.50 [m].') == 30


def test_param_circle_refuses_to_divide_by_zero(stage: Any) -> None:
    stage.start('part3_beyond_basics', 'param_circle.py', '--ros-args', '-p', 'radius:=0.0')
    stage.until(250)
    assert [message.twist.angular.z for message in stage.messages('/cmd_vel')] == [0.0, 0.0]


@pytest.mark.parametrize(('file', 'start'), [('turtlebot3_world', (-2.0, -0.5)), ('turtlebot3_house', (-2.0, -0.5))])
def test_the_worlds_have_the_robot_and_its_frames_and_say_what_is_missing(file: str, start: tuple[float, float]) -> None:
    recording = edulaunch.run('turtlebot3_gazebo', f'{file}.launch.py', duration_s=1.0)
    said = ''.join(line.text for line in recording.output)
    assert f'[launch.user]: {file}: edulaunch has the robot and the floor, but neither' in said
    assert position(recording.messages('/odom')[0][1]) == start
    assert recording.frames_at(1.0)['base_scan'].parent == 'base_link'


@pytest.mark.parametrize('model', ['burger', 'waffle', 'waffle_pi'])
def test_each_model_has_a_description(model: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv('TURTLEBOT3_MODEL', model)
    frames = edulaunch.run('turtlebot3_gazebo', 'robot_state_publisher.launch.py', duration_s=0.5).frames_at(0.5)
    assert frames['base_link'].parent == 'base_footprint' and ('camera_link' in frames) == (model != 'burger')
