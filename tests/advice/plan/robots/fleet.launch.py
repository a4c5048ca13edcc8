"""A fleet in simulation: a world, then each robot in a group of its own, with an included file that is written for one robot."""
import os

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, GroupAction, IncludeLaunchDescription, LogInfo, OpaqueFunction, TimerAction
from launch.launch_description_sources import AnyLaunchDescriptionSource
from launch.substitutions import LaunchConfiguration, PythonExpression, ThisLaunchFileDir
from launch_ros.actions import Node, PushRosNamespace, SetParameter, SetRemap

ROBOTS = [{'name': 'scout', 'x': 0.0, 'lidar': True}, {'name': 'mule', 'x': -1.5, 'lidar': False}]


def robot(spec, delay):
    here = os.path.dirname(__file__)
    actions = [
        PushRosNamespace(spec['name']),
        SetRemap('/tf', 'tf'),
        SetParameter('frame_prefix', spec['name'] + '/'),
        Node(package='acme_simulator', executable='spawn', output='screen',
             arguments=['-entity', spec['name'], '-x', str(spec['x']), '-z', '0.1']),
    ]
    if spec['lidar']:
        actions.append(IncludeLaunchDescription(
            AnyLaunchDescriptionSource(os.path.join(here, 'lidar.launch.yaml')),
            launch_arguments={'frame_id': spec['name'] + '_laser', 'filter': LaunchConfiguration('filter')}.items()))
    return TimerAction(period=delay, actions=[GroupAction(actions)])


def farewell(context, *, count):
    return [LogInfo(msg=f"{count} robots in {LaunchConfiguration('world').perform(context)}")]


def generate_launch_description():
    return LaunchDescription([
        DeclareLaunchArgument('world', default_value='yard'),
        DeclareLaunchArgument('filter', default_value='false'),
        SetParameter('use_sim_time', True),
        Node(package='acme_simulator', executable='world', name='world',
             arguments=[[ThisLaunchFileDir(), '/worlds/', LaunchConfiguration('world'), '.sdf']],
             parameters=[{'seed': PythonExpression(['40 + ', '2']), 'lights': ['sun', LaunchConfiguration('world')]}]),
        *[robot(spec, 1.0 + index) for index, spec in enumerate(ROBOTS)],
        OpaqueFunction(function=farewell, kwargs={'count': len(ROBOTS)}),
    ])
