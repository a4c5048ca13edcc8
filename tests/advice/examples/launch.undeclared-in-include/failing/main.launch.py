from launch import LaunchDescription
from launch.actions import IncludeLaunchDescription
from launch.substitutions import PathJoinSubstitution, ThisLaunchFileDir


def generate_launch_description():
    return LaunchDescription([
        IncludeLaunchDescription(
            PathJoinSubstitution([ThisLaunchFileDir(), 'talk.launch.py']),
            launch_arguments={'tpoic': 'news'}.items(),
        ),
    ])
