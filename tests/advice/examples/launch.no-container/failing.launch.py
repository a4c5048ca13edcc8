from launch import LaunchDescription
from launch_ros.actions import ComposableNodeContainer, LoadComposableNodes
from launch_ros.descriptions import ComposableNode

def generate_launch_description():
    container = ComposableNodeContainer(name='my_box', namespace='', package='rclcpp_components',
                                        executable='component_container', composable_node_descriptions=[])
    load = LoadComposableNodes(
        target_container='my_container',
        composable_node_descriptions=[ComposableNode(package='composition', plugin='composition::Listener', name='listener'),
                                      ComposableNode(package='composition', plugin='composition::Talker', name='talker')])
    return LaunchDescription([container, load])
