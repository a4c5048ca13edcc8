"""The turtle of the first pool should drive a circle, and that of the second one should copy it. No turtle moves.

    ros2 launch two_pools.launch.py speed:=1.0

There are two mistakes. Find them with the tools (ros2 topic info, ros2 node info, edulaunch doctor) before you read the file.

Grade it with `edugrade exercises/two_pools.launch.py`. Add `--hint 1` for a hint.
"""
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, ExecuteProcess
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def generate_launch_description():
    values = ['{linear: {x: ', LaunchConfiguration('speed'), '}, angular: {z: 1.0}}']
    # TODO 1: which turtle receives the commands of the driver?
    drive = ['ros2', 'topic', 'pub', '-r', '1', '/turtle1/cmd_vel', 'geometry_msgs/msg/Twist']
    return LaunchDescription([
        DeclareLaunchArgument('speed', default_value='1.0', description='Speed of the first turtle, in metres per second.'),
        Node(package='turtlesim', executable='turtlesim_node', name='sim', namespace='first'),
        Node(package='turtlesim', executable='turtlesim_node', name='sim', namespace='second'),
        ExecuteProcess(cmd=[*drive, values]),
        # TODO 2: to which topic does mimic subscribe?
        Node(package='turtlesim', executable='mimic', name='mimic', remappings=[
            ('input', '/first/turtle1'),
            ('output/cmd_vel', '/second/turtle1/cmd_vel'),
        ]),
    ])
