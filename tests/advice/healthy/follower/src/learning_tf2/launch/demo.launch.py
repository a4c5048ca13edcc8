from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        Node(package='turtlesim', executable='turtlesim_node', name='sim'),
        Node(package='learning_tf2', executable='broadcaster', name='broadcaster1', parameters=[{'turtlename': 'turtle1'}]),
        Node(package='learning_tf2', executable='broadcaster', name='broadcaster2', parameters=[{'turtlename': 'turtle2'}]),
        Node(package='learning_tf2', executable='listener', parameters=[{'target_frame': 'turtle1'}]),
    ])
