from launch import LaunchDescription
from launch.actions import (DeclareLaunchArgument, ExecuteProcess, GroupAction, LogInfo, OpaqueFunction,
                            RegisterEventHandler, TimerAction)
from launch.event_handlers import OnProcessExit
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node, PushRosNamespace


def make_members(context, *args, **kwargs):
    actions = []
    for number in range(2, int(LaunchConfiguration('size').perform(context)) + 1):
        name = f'turtle{number}'
        spawn = ExecuteProcess(
            cmd=['ros2', 'service', 'call', '/spawn', 'turtlesim/srv/Spawn',
                 f'"{{x: {1.5 * number}, y: 2.0, theta: 1.5708, name: {name}}}"'],
            shell=True, output='log')
        member = GroupAction([
            PushRosNamespace(name),
            Node(package='swarm', executable='member', parameters=[{'number': number}]),
        ])
        actions.append(spawn)
        actions.append(RegisterEventHandler(OnProcessExit(
            target_action=spawn, on_exit=[LogInfo(msg=f'{name} is there'), member])))
    return actions


def generate_launch_description():
    return LaunchDescription([
        DeclareLaunchArgument('size', default_value='2'),
        Node(package='turtlesim', executable='turtlesim_node', name='sim'),
        TimerAction(period=1.0, actions=[OpaqueFunction(function=make_members)]),
    ])
