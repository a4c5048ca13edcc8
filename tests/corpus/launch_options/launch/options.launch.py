from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, ExecuteProcess, GroupAction, IncludeLaunchDescription, OpaqueFunction
from launch.conditions import IfCondition, UnlessCondition
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch.substitutions import LaunchConfiguration, PathJoinSubstitution, PythonExpression, TextSubstitution
from launch_ros.actions import Node, PushRosNamespace
from launch_ros.substitutions import FindPackageShare


def more_relays(context):
    number = int(LaunchConfiguration('relays').perform(context))
    return [Node(package='launch_options', executable='relay', name=f'relay_{i}',
                 remappings=[('in', 'first' if i == 0 else f'step{i}'),
                             ('out', 'last' if i == number - 1 else f'step{i + 1}')])
            for i in range(number)]


def generate_launch_description():
    word = LaunchConfiguration('word')
    return LaunchDescription([
        DeclareLaunchArgument('word', default_value=TextSubstitution(text='ping')),
        DeclareLaunchArgument('relays', default_value='2', choices=['1', '2', '3']),
        DeclareLaunchArgument('loud', default_value='false'),
        GroupAction([
            PushRosNamespace('chain'),
            Node(package='launch_options', executable='start', parameters=[{'word': word}]),
            OpaqueFunction(function=more_relays),
        ]),
        Node(package='launch_options', executable='relay', namespace='lonely',
             remappings=[('in', '/chain/last'), ('~/count', 'counter')],
             condition=UnlessCondition(LaunchConfiguration('loud'))),
        ExecuteProcess(cmd=['ros2', 'node', 'list'], condition=IfCondition(
            PythonExpression(["'", word, "' == 'shout'"]))),
        IncludeLaunchDescription(
            PythonLaunchDescriptionSource(PathJoinSubstitution(
                [FindPackageShare('launch_options'), 'launch', 'one.launch.py'])),
            launch_arguments={'name': 'included'}.items()),
    ])
