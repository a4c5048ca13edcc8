"""Two turtle worlds, three turtles, broadcasters, a carrot, a follower and a mimic: the load of the large-project tutorial."""

from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription(
        [
            Node(package='turtlesim', executable='turtlesim_node', name='sim'),
            Node(package='turtlesim', executable='turtlesim_node', name='sim', namespace='turtlesim2'),
            Node(
                package='turtle_tf2_py',
                executable='turtle_tf2_broadcaster',
                name='broadcaster1',
                parameters=[{'turtlename': 'turtle1'}],
            ),
            Node(
                package='turtle_tf2_py',
                executable='turtle_tf2_broadcaster',
                name='broadcaster2',
                parameters=[{'turtlename': 'turtle2'}],
            ),
            Node(
                package='turtle_tf2_py',
                executable='turtle_tf2_listener',
                name='listener',
                parameters=[{'target_frame': 'carrot1'}],
            ),
            Node(
                package='turtlesim',
                executable='mimic',
                name='mimic',
                remappings=[('/input/pose', '/turtle2/pose'), ('/output/cmd_vel', '/turtlesim2/turtle1/cmd_vel')],
            ),
            Node(package='turtle_tf2_py', executable='fixed_frame_tf2_broadcaster', name='fixed_broadcaster'),
        ]
    )
