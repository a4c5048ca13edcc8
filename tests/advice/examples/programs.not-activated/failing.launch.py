from launch import LaunchDescription
from launch.actions import ExecuteProcess
from launch_ros.actions import LifecycleNode


def generate_launch_description():
    return LaunchDescription(
        [
            LifecycleNode(package='lifecycle', executable='lifecycle_talker', name='lc_talker', namespace=''),
            ExecuteProcess(cmd=['ros2 lifecycle set /lc_talker configure'], shell=True),
        ]
    )
