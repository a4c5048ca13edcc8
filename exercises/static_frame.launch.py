"""A laser and a camera on the mast of a robot, as static frames.

    ros2 launch static_frame.launch.py height:=0.8

Sensors report what they see from where they are. A static frame tells tf where that is: said once, it holds for ever.
The program for it is static_transform_publisher of the package tf2_ros, with the arguments --x --y --z (in meters),
--yaw --pitch --roll (in radians), --frame-id (the parent) and --child-frame-id (the new frame). What is not given is 0.
tf2_echo, which is started already, prints the camera as seen from base_link as soon as tf knows it. Fill the two gaps.

Grade it: edugrade exercises/static_frame.launch.py        A hint: edugrade exercises/static_frame.launch.py --hint 1
"""
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        DeclareLaunchArgument('height', default_value='0.5', description='Height of the laser (in meters).'),
        # TODO 1: the frame laser in the frame base_link: 0.2 m in front (x), and as high (z) as the launch argument says

        # TODO 2: the frame camera in the frame laser: 0.1 m above it, turned a quarter to the left (a yaw of 1.5708)

        Node(
            package='tf2_ros',
            executable='tf2_echo',
            arguments=['base_link', 'camera'],
            output='screen',
        ),
    ])
