"""A laser and a camera on the mast of a robot, as static frames.

    ros2 launch static_frame.launch.py height:=0.8

Sensors report what they see relative to themselves. A static frame tells tf2 once, and for the whole run, where a sensor
is. The program static_transform_publisher of the package tf2_ros publishes it. Its arguments are --x --y --z (in metres),
--yaw --pitch --roll (in radians), --frame-id (the parent) and --child-frame-id (the new frame). Numbers that you omit are 0.
tf2_echo, which already runs, prints the camera as seen from base_link as soon as tf2 knows it. Fill the two gaps.

Grade it with `edugrade exercises/static_frame.launch.py`. Add `--hint 1` for a hint.
"""
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        DeclareLaunchArgument('height', default_value='0.5', description='Height of the laser (in metres).'),
        # TODO 1: publish laser relative to base_link: 0.2 m in front (x); the launch argument height is its z

        # TODO 2: publish camera relative to laser: 0.1 m above it, a quarter turn to the left (yaw 1.5708)

        Node(
            package='tf2_ros',
            executable='tf2_echo',
            arguments=['base_link', 'camera'],
            output='screen',
        ),
    ])
