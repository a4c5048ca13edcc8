from launch import LaunchDescription
from launch_ros.actions import Node


def broadcaster(name, *arguments):
    return Node(package='learning_tf2_py', executable='static_turtle_tf2_broadcaster', name=name,
                arguments=[str(argument) for argument in arguments])


def generate_launch_description():
    return LaunchDescription([
        broadcaster('first', 'mystaticturtle', 0, 0, 1, 0, 0, 0),
        broadcaster('second', 'tower', 2, 1, 0, 0, 0, 1.5707963),
    ])
