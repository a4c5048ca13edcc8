from launch import LaunchDescription
from launch.actions import ExecuteProcess, GroupAction
from launch_ros.actions import Node, PushRosNamespace


def generate_launch_description():
    return LaunchDescription([
        GroupAction([PushRosNamespace('robot'), Node(package='turtlesim', executable='turtlesim_node'), ExecuteProcess(cmd=['ros2', 'topic', 'pub', '-r', '5', '/robot/turtle1/cmd_vel', 'geometry_msgs/msg/Twist', '{linear: {x: 0.2}, angular: {z: 0.4}}'])]),
    ])
