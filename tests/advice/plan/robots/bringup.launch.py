"""A mobile robot's bringup in the manner of navigation stacks: many arguments, rewritten parameters, conditions, a container."""
import os

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, GroupAction, IncludeLaunchDescription, OpaqueFunction, SetEnvironmentVariable
from launch.conditions import IfCondition
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch.substitutions import LaunchConfiguration, PathJoinSubstitution, PythonExpression
from launch_ros.actions import LoadComposableNodes, Node, PushRosNamespace, SetParameter
from launch_ros.descriptions import ComposableNode, ParameterFile
from launch_ros.substitutions import FindPackageShare


def speak_of(context):
    robots = LaunchConfiguration('robots').perform(context).split()
    return [Node(package='acme_navigation', executable='watcher', namespace=robot, output='screen',
                 parameters=[{'robot': robot, 'rate': 5.0}]) for robot in robots]


def generate_launch_description():
    bringup = get_package_share_directory('acme_bringup')
    composed = LaunchConfiguration('use_composition')
    remappings = [('/tf', 'tf'), ('/tf_static', 'tf_static')]
    parameters = ParameterFile(LaunchConfiguration('params_file'), allow_substs=True)
    servers = ['controller_server', 'planner_server', 'behavior_server']
    return LaunchDescription([
        SetEnvironmentVariable('RCUTILS_LOGGING_BUFFERED_STREAM', '1'),
        DeclareLaunchArgument('namespace', default_value='', description='Top-level namespace'),
        DeclareLaunchArgument('use_composition', default_value='False'),
        DeclareLaunchArgument('use_sim_time', default_value='false'),
        DeclareLaunchArgument('robots', default_value='alpha beta'),
        DeclareLaunchArgument('params_file', default_value=os.path.join(bringup, 'params', 'navigation.yaml')),
        GroupAction([
            PushRosNamespace(LaunchConfiguration('namespace')),
            SetParameter('use_sim_time', LaunchConfiguration('use_sim_time')),
            Node(condition=IfCondition(composed), package='rclcpp_components', executable='component_container_isolated',
                 name='nav_container', parameters=[parameters], remappings=remappings, output='screen'),
            IncludeLaunchDescription(
                PythonLaunchDescriptionSource(os.path.join(bringup, 'launch', 'localization.launch.py')),
                condition=IfCondition(PythonExpression(['not ',
                                                        "'", LaunchConfiguration('use_sim_time'), "' == 'true'"])),
                launch_arguments={'map': PathJoinSubstitution([FindPackageShare('acme_maps'), 'office.yaml'])}.items()),
        ]),
        GroupAction(condition=IfCondition(PythonExpression(['not ', composed])), actions=[
            *(Node(package=f'nav2_{server}', executable=server, respawn=True, respawn_delay=2.0, parameters=[parameters],
                   arguments=['--ros-args', '--log-level', 'info'], remappings=remappings) for server in servers),
            Node(package='nav2_lifecycle_manager', executable='lifecycle_manager', name='lifecycle_manager_navigation',
                 parameters=[{'autostart': True, 'node_names': servers}])]),
        LoadComposableNodes(condition=IfCondition(composed), target_container='nav_container', composable_node_descriptions=[
            ComposableNode(package='nav2_controller', plugin='nav2_controller::ControllerServer', name='controller_server',
                           parameters=[parameters], remappings=remappings)]),
        OpaqueFunction(function=speak_of),
    ])
