"""turtle2 runs after a carrot that hangs at turtle1: fixed, or moving.

    ros2 launch carrot.launch.py carrot:=moving
"""
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, IncludeLaunchDescription
from launch.conditions import IfCondition
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch.substitutions import EqualsSubstitution, LaunchConfiguration, PathJoinSubstitution
from launch_ros.actions import Node
from launch_ros.substitutions import FindPackageShare


def generate_launch_description():
    carrot = LaunchConfiguration('carrot')
    return LaunchDescription([
        DeclareLaunchArgument(
            'carrot',
            default_value='fixed',
            choices=['fixed', 'moving'],
            description='Whether the carrot hangs still or swings.',
        ),
        IncludeLaunchDescription(
            PythonLaunchDescriptionSource(
                PathJoinSubstitution([FindPackageShare('turtle_tf2_py'), 'launch', 'turtle_tf2_demo.launch.py'])
            ),
            launch_arguments={'target_frame': 'carrot1'}.items(),
        ),
        Node(
            package='turtle_tf2_py',
            executable='fixed_frame_tf2_broadcaster',
            name='fixed_broadcaster',
            condition=IfCondition(EqualsSubstitution(carrot, 'fixed')),
        ),
        Node(
            package='turtle_tf2_py',
            executable='dynamic_frame_tf2_broadcaster',
            name='dynamic_broadcaster',
            condition=IfCondition(EqualsSubstitution(carrot, 'moving')),
        ),
    ])
