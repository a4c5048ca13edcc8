"""A node that should log where turtle1 is, and where it was. Each time tf2 reports: extrapolation into the future.

    ros2 launch where_now where_now.launch.py ago:=0.5

Two lines of where_now/where.py are wrong; this file is right.

Grade it with `edugrade exercises/where_now`. Add `--hint 1` for a hint.
"""
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, ExecuteProcess
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def generate_launch_description():
    drive = ['ros2', 'topic', 'pub', '-r', '1', '/turtle1/cmd_vel', 'geometry_msgs/msg/Twist']
    return LaunchDescription([
        DeclareLaunchArgument('ago', default_value='0.5', description='Time before now, in seconds.'),
        DeclareLaunchArgument('turn', default_value='0.5', description='Turning speed of turtle1, in radians per second.'),
        Node(package='turtlesim', executable='turtlesim_node', name='sim'),
        ExecuteProcess(cmd=[*drive, ['{linear: {x: 0.5}, angular: {z: ', LaunchConfiguration('turn'), '}}']]),
        Node(package='turtle_tf2_py', executable='turtle_tf2_broadcaster', name='broadcaster',
             parameters=[{'turtlename': 'turtle1'}]),
        Node(package='where_now', executable='where', parameters=[{'ago': LaunchConfiguration('ago')}]),
    ])
