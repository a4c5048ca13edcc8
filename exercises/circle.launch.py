"""A robot that drives a circle, and its world, in one launch file.

    ros2 launch circle.launch.py circle_radius:=0.8

The node param_circle.py of the package part3_beyond_basics publishes velocities for a circle. Its parameter
`radius` is the radius in metres; the default is 0.5. No robot receives the velocities yet, and the user
cannot choose the radius. Fill the three gaps.

Grade it with `edugrade exercises/circle.launch.py`. Add `--hint 1` for a hint.
"""
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        # TODO 1: declare the launch argument circle_radius, with a description and the default value 1.0

        # TODO 2: include empty_world.launch.py from the folder launch of the package turtlebot3_gazebo

        Node(
            package='part3_beyond_basics',
            executable='param_circle.py',
            name='my_param_circle_node',
            # TODO 3: set the parameter radius to the value of the launch argument circle_radius
        ),
    ])
