"""turtle2 follows a carrot, a frame at turtle1 that is either fixed or moving.

    ros2 launch carrot.launch.py carrot:=moving

The included demo starts turtlesim, turtle1, and turtle2, which drives to a frame. The launch argument `target_frame` of
the demo names this frame; the default is turtle1. Two programs can broadcast the frame carrot1 relative to turtle1:
fixed_frame_tf2_broadcaster puts it two metres to the left, dynamic_frame_tf2_broadcaster moves it from side to side.
At the moment both run and contradict each other. Fill the three gaps.

Grade it with `edugrade exercises/carrot.launch.py`. Add `--hint 1` for a hint.
"""
from launch import LaunchDescription
from launch.actions import IncludeLaunchDescription
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch.substitutions import PathJoinSubstitution
from launch_ros.actions import Node
from launch_ros.substitutions import FindPackageShare


def generate_launch_description():
    return LaunchDescription([
        # TODO 1: declare the launch argument carrot with the choices fixed and moving, and the default fixed

        IncludeLaunchDescription(
            PythonLaunchDescriptionSource(
                PathJoinSubstitution([FindPackageShare('turtle_tf2_py'), 'launch', 'turtle_tf2_demo.launch.py'])
            ),
            # TODO 2: set the demo's launch argument target_frame to carrot1
        ),

        # TODO 3: give each of the two nodes a condition, so that the launch argument carrot chooses one of them
        Node(
            package='turtle_tf2_py',
            executable='fixed_frame_tf2_broadcaster',
            name='fixed_broadcaster',
        ),
        Node(
            package='turtle_tf2_py',
            executable='dynamic_frame_tf2_broadcaster',
            name='dynamic_broadcaster',
        ),
    ])
