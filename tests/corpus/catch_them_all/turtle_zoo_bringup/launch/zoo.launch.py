import os
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    ld = LaunchDescription()
    config = os.path.join(get_package_share_directory("turtle_zoo_bringup"), "config", "zoo.yaml")
    turtlesim_node = Node(
        package="turtlesim",
        executable="turtlesim_node"
    )
    turtle_spawner_node = Node(
        package="turtle_zoo",
        executable="turtle_spawner",
        parameters=[config]
    )
    turtle_controller_node = Node(
        package="turtle_zoo",
        executable="turtle_controller",
        parameters=[config]
    )
    ld.add_action(turtlesim_node)
    ld.add_action(turtle_spawner_node)
    ld.add_action(turtle_controller_node)
    return ld
