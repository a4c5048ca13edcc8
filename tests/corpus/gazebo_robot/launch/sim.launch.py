import os

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, ExecuteProcess, IncludeLaunchDescription, RegisterEventHandler
from launch.conditions import IfCondition
from launch.event_handlers import OnProcessExit
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch.substitutions import Command, FindExecutable, LaunchConfiguration, PathJoinSubstitution
from launch_ros.actions import ComposableNodeContainer, Node
from launch_ros.descriptions import ComposableNode
from launch_ros.parameter_descriptions import ParameterValue
from launch_ros.substitutions import FindPackageShare


def generate_launch_description():
    pkg = get_package_share_directory('gazebo_robot')
    gazebo = IncludeLaunchDescription(
        PythonLaunchDescriptionSource([os.path.join(get_package_share_directory('gazebo_ros'), 'launch', 'gazebo.launch.py')]),
        launch_arguments={'world': os.path.join(pkg, 'worlds', 'room.world')}.items())
    slam = IncludeLaunchDescription(
        PythonLaunchDescriptionSource(PathJoinSubstitution([FindPackageShare('slam_toolbox'), 'launch', 'online_async_launch.py'])),
        launch_arguments={'use_sim_time': 'true'}.items())
    description = ParameterValue(Command([FindExecutable(name='xacro'), ' ', os.path.join(pkg, 'urdf', 'robot.urdf.xacro')]), value_type=str)
    spawn = Node(package='gazebo_ros', executable='spawn_entity.py', arguments=['-topic', 'robot_description', '-entity', 'robot'])
    return LaunchDescription([
        DeclareLaunchArgument('rviz', default_value='true'),
        gazebo,
        slam,
        Node(package='robot_state_publisher', executable='robot_state_publisher', parameters=[{'robot_description': description}]),
        Node(package='joint_state_publisher_gui', executable='joint_state_publisher_gui'),
        spawn,
        RegisterEventHandler(OnProcessExit(target_action=spawn, on_exit=[
            Node(package='controller_manager', executable='spawner', arguments=['diff_drive_controller'])])),
        ComposableNodeContainer(name='images', namespace='', package='rclcpp_components', executable='component_container',
                                composable_node_descriptions=[ComposableNode(package='image_proc', plugin='image_proc::RectifyNode')]),
        Node(package='rviz2', executable='rviz2', condition=IfCondition(LaunchConfiguration('rviz'))),
        ExecuteProcess(cmd=['rviz2', '-f', 'odom']),
        ExecuteProcess(cmd=['gazebo_of_long_ago', '--verbose']),
        Node(package='gazebo_robot', executable='eye', output='screen'),
        Node(package='gazebo_robot', executable='health', output='screen'),
        Node(package='gazebo_robot', executable='driver', output='screen'),
    ])
