"""turtle2 follows a carrot, a frame at turtle1 that is either fixed or moving.

    ros2 launch carrot.launch.py carrot:=moving

The included demo starts turtlesim, turtle1, and turtle2, which drives to a frame. The launch argument `target_frame` of
the demo names this frame; the default is turtle1. Two programs can broadcast the frame carrot1 relative to turtle1:
fixed_frame_tf2_broadcaster puts it two metres to the left, dynamic_frame_tf2_broadcaster moves it from side to side.
At the moment both run and contradict each other. Fill the three gaps.
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
