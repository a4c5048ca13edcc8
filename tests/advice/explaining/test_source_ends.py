"""Endpoints, frames and names read from the source of a program."""

from __future__ import annotations

from pathlib import Path

import pytest

from edulaunch.advice.explaining.source_ends import SourceEnds, files_of, read_ends

PROGRAM = """
from geometry_msgs.msg import Twist
from rclpy.node import Node
from tf2_ros import TransformBroadcaster
from turtlesim.msg import Pose

class Follower(Node):
    def __init__(self):
        super().__init__('follower')
        self.declare_parameter('turtle', 'turtle1')
        self.me = self.get_parameter('turtle').get_parameter_value().string_value
        self.out = self.create_publisher(Twist, f'{self.me}/cmd_vel', 10)
        self.create_subscription(Pose, topic=self.me + '/pose', callback=self.on_pose, qos_profile=10)
        self.tf = TransformBroadcaster(self)
        for other in ('a', 'b'):
            self.create_client(Twist, other)

    def on_pose(self, pose):
        t = TransformStamped()
        t.header.frame_id = 'world'
        t.child_frame_id = self.me
        self.tf.sendTransform(t)
"""


def read(tmp_path: Path, text: str, **parameters: str) -> SourceEnds:
    path = tmp_path / 'program.py'
    path.write_text(text)
    return read_ends(files_of(str(path)), parameters)


def test_names_follow_the_parameters_of_the_launch_file(tmp_path: Path) -> None:
    found = read(tmp_path, PROGRAM, turtle='turtle2')
    assert found.name == 'follower'
    assert ('publisher', 'turtle2/cmd_vel', 'geometry_msgs/msg/Twist') in found.ends
    assert ('subscription', 'turtle2/pose', 'turtlesim/msg/Pose') in found.ends
    assert found.frames == [('world', 'turtle2', False)]
    assert ('publisher', 'turtle1/cmd_vel', 'geometry_msgs/msg/Twist') in read(tmp_path, PROGRAM).ends


def test_a_name_that_only_a_run_decides_is_unknown(tmp_path: Path) -> None:
    assert read(tmp_path, PROGRAM).unknown == ['client (name: other)']


@pytest.mark.parametrize(
    'line',
    ['self.me = input()', "self.me = 'x'\n        self.me = 'y'", "self.me = 'x' if ready() else 'y'", "self.me, b = 'xy'"],
)
def test_a_variable_that_is_not_certain_is_unknown(tmp_path: Path, line: str) -> None:
    text = PROGRAM.replace("self.me = self.get_parameter('turtle').get_parameter_value().string_value", line)
    found = read(tmp_path, text)
    assert [end for end in found.ends if end[0] == 'publisher'] == [('publisher', '/tf', 'tf2_msgs/msg/TFMessage')]
    assert "publisher (name: f'{self.me}/cmd_vel')" in found.unknown and "frame self.me in 'world'" in found.unknown


def test_files_beside_the_program_are_read_too(tmp_path: Path) -> None:
    (tmp_path / 'talking.py').write_text(
        "class Talking:\n    def go(self, node):\n        node.create_publisher(String, 'news', 1)\n"
    )
    found = read(tmp_path, "from .talking import Talking\nimport rclpy\nnode = rclpy.create_node('desk')\n")
    assert (found.name, found.ends) == ('desk', [('publisher', 'news', 'String')])


def test_a_file_that_does_not_parse_has_nothing(tmp_path: Path) -> None:
    assert read(tmp_path, 'def (') == SourceEnds(None, [], [], [])
