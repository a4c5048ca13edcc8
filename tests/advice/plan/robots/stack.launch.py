"""A whole stack out of others' files: the base of an included file, navigation in a scope, what leaks and what does not."""
from launch import LaunchDescription
from launch.actions import (
    AppendEnvironmentVariable,
    DeclareLaunchArgument,
    GroupAction,
    IncludeLaunchDescription,
    OpaqueFunction,
    SetLaunchConfiguration,
    Shutdown,
    UnsetEnvironmentVariable,
)
from launch.conditions import IfCondition
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch.substitutions import LaunchConfiguration, PathJoinSubstitution, PythonExpression, ThisLaunchFileDir
from launch_ros.actions import Node, PushRosNamespace, SetParametersFromFile
from launch_ros.substitutions import FindPackageShare


def only_with_two(context):
    if LaunchConfiguration('level').perform(context) == '2':
        return [Node(package='acme_stack', executable='second_floor', parameters=[{'level': 2}])]
    return None


def generate_launch_description():
    level = LaunchConfiguration('level')
    return LaunchDescription([
        DeclareLaunchArgument('level', default_value='2'),
        AppendEnvironmentVariable('STACK_PATH', 'a', prepend=True),
        UnsetEnvironmentVariable('DISPLAY'),
        IncludeLaunchDescription(PythonLaunchDescriptionSource([ThisLaunchFileDir(), '/base.launch.py']),
                                 launch_arguments={'model': 'mk1', 'sim': 'true'}.items()),
        GroupAction(scoped=True, forwarding=False, launch_configurations={'level': level}, actions=[
            PushRosNamespace('isolated'),
            Node(package='acme_stack', executable='model', name=['model_', LaunchConfiguration('model', default='unknown')])]),
        GroupAction(scoped=False, actions=[SetLaunchConfiguration('level', PythonExpression([level, ' + 0'])), PushRosNamespace('floor')]),
        Node(package='acme_stack', executable='model', name=['model_', LaunchConfiguration('model')], namespace='deck'),
        OpaqueFunction(function=only_with_two),
        GroupAction([
            SetParametersFromFile(PathJoinSubstitution([FindPackageShare('acme_stack'), 'config', 'all.yaml'])),
            Node(package='acme_stack', executable='planner', name='planner', namespace='/global')],
            condition=IfCondition(PythonExpression([level, ' < 2']))),
        Node(package='acme_stack', executable='guard', on_exit=Shutdown()),
    ])
