"""tf frames read from a recording."""

from __future__ import annotations

from pathlib import Path

import edulaunch

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
