from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, ExecuteProcess
from launch.conditions import IfCondition
from launch.substitutions import LaunchConfiguration


def generate_launch_description():
    return LaunchDescription([
        DeclareLaunchArgument('record', default_value='false', description='true: record the frames in a bag.'),
        ExecuteProcess(cmd=['ros2', 'bag', 'record', '-o', 'my_launch/fleet_bag', '/tf', '/tf_static'],
                       condition=IfCondition(LaunchConfiguration('record'))),
    ])
