from launch import LaunchDescription
from launch.actions import TimerAction
from launch_ros.actions import Node


def generate_launch_description():
    ld = LaunchDescription()

    client_node = Node(package="late_server", executable="add_client")
    plain = Node(package="late_server", executable="add_client_no_oop", arguments=["8"])
    server_node = Node(package="late_server", executable="add_server")

    ld.add_action(client_node)
    ld.add_action(plain)
    ld.add_action(TimerAction(period=2.6, actions=[server_node]))
    return ld
