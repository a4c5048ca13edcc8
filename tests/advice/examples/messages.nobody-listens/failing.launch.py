from launch import LaunchDescription
from launch.actions import ExecuteProcess


def generate_launch_description():
    return LaunchDescription(
        [
            ExecuteProcess(
                cmd=['ros2', 'topic', 'pub', '-r', '2', '/turtle1/cmd_vel', 'geometry_msgs/msg/Twist', '{angular: {z: 0.5}}']
            ),
        ]
    )
