"""Advice that was wrong in reports of the grader: an argument as a string, another topic in a bag, the frame of another turtle."""

from __future__ import annotations

from pathlib import Path

import edulaunch
from edulaunch.advice import judge
from edulaunch.advice.rendering import rendered

TREES = """from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch_ros.actions import Node


def frame(parent, child):
    words = ['--frame-id', parent, '--child-frame-id', child]
    return Node(package='tf2_ros', executable='static_transform_publisher', arguments=words)


def generate_launch_description():
    return LaunchDescription([
        DeclareLaunchArgument('leader', default_value='turtle1'),
        frame('world', 'turtle1'),
        frame('leader', 'carrot'),
        Node(package='tf2_ros', executable='tf2_echo', arguments=['world', 'carrot']),
    ])
"""
BAG = """from launch import LaunchDescription
from launch.actions import ExecuteProcess
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        Node(package='turtlesim', executable='turtlesim_node'),
        ExecuteProcess(cmd=['ros2', 'bag', 'record', '-o', 'drive', '/turtle1/cmd_vel']),
    ])
"""
ELSEWHERE = """import rclpy
from geometry_msgs.msg import TransformStamped
from rclpy.node import Node
from tf2_ros import TransformBroadcaster


class Elsewhere(Node):
    def __init__(self):
        super().__init__('elsewhere')
        self.tf = TransformBroadcaster(self)
        self.timer = self.create_timer(0.05, self.send)

    def send(self):
        t = TransformStamped()
        t.header.stamp = self.get_clock().now().to_msg()
        t.header.frame_id, t.child_frame_id = 'world', 'turtle1'
        t.transform.translation.x, t.transform.translation.y = {place}
        t.transform.rotation.z, t.transform.rotation.w = 1.0, 0.0
        self.tf.sendTransform(t)


rclpy.init()
rclpy.spin(Elsewhere())
"""

FRAME = """import sys

from launch import LaunchDescription
from launch.actions import ExecuteProcess
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        Node(package='turtlesim', executable='turtlesim_node'),
        ExecuteProcess(cmd=[sys.executable, '{program}']),
    ])
"""


def actions(folder: Path, text: str) -> dict[str, str]:
    file = folder / 'a.launch.py'
    file.write_text(text, encoding='utf-8')
    with edulaunch.Session() as session:
        session.launch(str(file))
        session.run(2.0)
        return {finding.rule: rendered(finding).do for finding in judge(session.recording())}


def test_the_name_of_an_argument_as_a_string_is_no_frame(tmp_path: Path) -> None:
    action = "write LaunchConfiguration('leader') instead of the string 'leader' where this frame is the parent"
    assert actions(tmp_path, TREES)['tf.separate-trees'] == action


def test_a_bag_is_not_asked_to_record_a_topic_of_another_kind(tmp_path: Path) -> None:
    assert actions(tmp_path, BAG)['messages.bag-of-nothing'] == 'look up the name of the topic with `ros2 topic list`'


def test_a_frame_far_from_its_turtle_gets_no_advice_on_its_rotation(tmp_path: Path) -> None:
    def rules(place: str) -> set[str]:
        (tmp_path / 'elsewhere.py').write_text(ELSEWHERE.format(place=place), encoding='utf-8')
        return set(actions(tmp_path, FRAME.format(program=str(tmp_path / 'elsewhere.py'))))

    assert 'tf.other-yaw' in rules('5.544445, 5.544445')
    assert 'tf.other-yaw' not in rules('1.0, 1.0')
