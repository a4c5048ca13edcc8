from launch import LaunchDescription
from launch_ros.actions import ComposableNodeContainer, Node
from launch_ros.descriptions import ComposableNode


def generate_launch_description():
    return LaunchDescription([
        ComposableNodeContainer(
            name='box',
            namespace='',
            package='rclcpp_components',
            executable='component_container',
            composable_node_descriptions=[
                ComposableNode(package='demo_nodes_cpp', plugin='demo_nodes_cpp::Talker'),
            ],
        ),
        Node(package='demo_nodes_cpp', executable='listener'),
    ])
