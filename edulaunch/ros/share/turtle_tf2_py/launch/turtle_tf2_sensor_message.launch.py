"""turtle3 drives in a circle and publishes stamped points, which a program can transform to the frame of turtle1."""

from launch import LaunchDescription
from launch_ros.actions import Node


def broadcaster(name, turtle):
    return Node(package='turtle_tf2_py', executable='turtle_tf2_broadcaster', name=name, parameters=[{'turtlename': turtle}])


def generate_launch_description():
    return LaunchDescription(
        [
            Node(package='turtlesim', executable='turtlesim_node', name='sim', output='screen'),
            broadcaster('broadcaster1', 'turtle1'),
            broadcaster('broadcaster2', 'turtle3'),
            Node(package='turtle_tf2_py', executable='turtle_tf2_message_broadcaster', name='message_broadcaster'),
        ]
    )
