"""There should be a dark sea in the north and a bright one in the south. Both are dark, and the south has other colours.

    ros2 launch two_seas two_seas.launch.py south_blue:=200

There are two mistakes: one here, one in config/sea.yaml. The file sea.launch.py is right: read it first.

Grade it with `edugrade exercises/two_seas`. Add `--hint 1` for a hint.
"""
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, GroupAction, IncludeLaunchDescription
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch.substitutions import LaunchConfiguration, PathJoinSubstitution
from launch_ros.actions import PushROSNamespace
from launch_ros.substitutions import FindPackageShare


def sea(namespace, **arguments):
    """Start one sea in its namespace, with arguments for sea.launch.py."""
    path = PathJoinSubstitution([FindPackageShare('two_seas'), 'launch', 'sea.launch.py'])
    include = IncludeLaunchDescription(PythonLaunchDescriptionSource(path), launch_arguments=arguments.items())
    return GroupAction([PushROSNamespace(namespace), include])


def generate_launch_description():
    blue = LaunchConfiguration('south_blue')
    return LaunchDescription([
        DeclareLaunchArgument('south_blue', default_value='200', description='0 to 255.'),
        sea('north'),
        # TODO 1: sea.launch.py does not declare this argument
        sea('south', south_blue=blue),
    ])
