"""tf frames read from a recording."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

import edulaunch
from edulaunch.engine.recording import Recording
from edulaunch.engine.recording.frames import FrameLink

from .conftest import turtle_run

SCRIPT = """
import rclpy
from geometry_msgs.msg import TransformStamped
from std_msgs.msg import String
from tf2_msgs.msg import TFMessage

rclpy.init()
node = rclpy.create_node('odd')
tf = node.create_publisher(TFMessage, '/tf', 10)
elsewhere = rclpy.Context()
rclpy.init(context=elsewhere)   # ROS 2 refuses a second type of one topic in one context
rclpy.create_node('other', context=elsewhere).create_publisher(String, '/tf', 10).publish(String(data='no transform'))
for second, x in ((5, 1.0), (3, 2.0)):
    stamped = TransformStamped()
    stamped.header.frame_id, stamped.child_frame_id = 'world', 'box'
    stamped.header.stamp.sec = 1700000000 + second
    stamped.transform.translation.x = x
    tf.publish(TFMessage(transforms=[stamped]))
"""


def test_the_newest_stamp_counts_and_other_types_on_the_topic_do_not(tmp_path: Path) -> None:
    (tmp_path / 'odd.py').write_text(SCRIPT)
    file = tmp_path / 'odd.launch.py'
    file.write_text(
        'from launch import LaunchDescription\nfrom launch.actions import ExecuteProcess\n'
        'def generate_launch_description():\n'
        f'    return LaunchDescription([ExecuteProcess(cmd=["python3", {str(tmp_path / "odd.py")!r}])])\n'
    )
    recording = edulaunch.run(file, duration_s=1)
    box = recording.frames_at(1.0)['box']
    assert (box.parent, box.translation, box.stamp_s) == ('world', (1.0, 0.0, 0.0), 5.0)
    assert 'box' in repr(recording.plot_tf_tree().scene)


def broadcast(*rows: tuple[str, float, float, float]) -> Recording:
    """Transforms of 'box' as (topic, published in s, stamp in s, x)."""
    content = turtle_run()._content
    names = {name: [row for row in rows if row[0] == name] for name in ('/tf', '/tf_static')}
    content['topics'] = [
        {
            'topic': name,
            'type': 'tf2_msgs/msg/TFMessage',
            'times': [round(published * 1e9) for _, published, _, _ in of_topic],
            'publishers': [1] * len(of_topic),
            'messages': [
                [
                    [
                        [
                            content['start_ns'] // 10**9 + int(stamp),
                            int(stamp % 1 * 1e9),
                            'world',
                            'box',
                            x,
                            0.0,
                            0.0,
                            0.0,
                            0.0,
                            0.0,
                            1.0,
                        ]
                    ]
                ]
                for _, _, stamp, x in of_topic
            ],
        }
        for name, of_topic in names.items()
    ]
    return Recording(content)


@pytest.mark.parametrize(
    'rows, time_s, x',
    [
        ([('/tf', 1.0, 0.5, 1.0), ('/tf', 1.0, 0.5, 2.0)], 1.0, 2.0),  # equal stamps: the last one published
        ([('/tf', 1.0, 0.5, 1.0), ('/tf', 1.5, 0.25, 2.0)], 2.0, 1.0),  # an older stamp comes late
        ([('/tf', 1.0, 0.5, 1.0), ('/tf', 2.0, 2.0, 2.0)], 2.0, 2.0),  # published at that very time
        ([('/tf', 1.0, 0.5, 1.0), ('/tf', 2.0, 2.0, 2.0)], 1.999, 1.0),
        ([('/tf_static', 1.0, 9.0, 1.0), ('/tf', 1.0, 0.5, 2.0)], 1.0, 2.0),  # what moves counts before what does not
    ],
)
def test_which_of_two_transforms_counts(rows: list[Any], time_s: float, x: float) -> None:
    assert broadcast(*rows).frames_at(time_s)['box'].translation[0] == x


@pytest.mark.parametrize(
    ('is_static', 'messages', 'first_s', 'last_s', 'rate_hz'),
    [
        (False, 5, 1.0, 3.0, 2.0),
        (False, 2, 0.0, 0.5, 2.0),
        (False, 1, 1.0, 1.0, None),
        (False, 3, 1.0, 1.0, None),
        (True, 5, 1.0, 3.0, None),
    ],
)
def test_the_rate_counts_the_spaces_between_broadcasts(
    is_static: bool, messages: int, first_s: float, last_s: float, rate_hz: float | None
) -> None:
    assert FrameLink('box', ['world'], is_static, ['/node'], messages, first_s, last_s).rate_hz == rate_hz
