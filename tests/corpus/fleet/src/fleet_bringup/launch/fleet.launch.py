import os
import sys

import yaml
from ament_index_python.packages import PackageNotFoundError, get_package_share_directory, get_package_share_path
from launch import LaunchContext, LaunchDescription
from launch.actions import DeclareLaunchArgument, ExecuteProcess, GroupAction, IncludeLaunchDescription, LogInfo, OpaqueFunction, TimerAction
from launch.launch_description_sources import PythonLaunchDescriptionSource

sys.path.append(os.path.join(os.path.dirname(__file__), 'include'))
from common import lc


def spawn_fleet(context: LaunchContext):
    with open(lc('fleet_file').perform(context)) as f:
        fleet = yaml.safe_load(f)
    only = [n for n in lc('only').perform(context).split(',') if n]
    actions = []
    for i, robot in enumerate(fleet['robots']):
        if not robot.get('enabled', True) or (only and robot['name'] not in only):
            actions.append(LogInfo(msg=f"skipping {robot['name']}"))
            continue
        inc = IncludeLaunchDescription(
            PythonLaunchDescriptionSource(os.path.join(get_package_share_directory('fleet_drivers'), 'launch', 'drivers.launch.py')),
            launch_arguments={
                'robot': robot['name'],
                'with_bms': str(robot['with_bms']),
                'simulate': str(robot['simulate']).lower(),
                'motor_names': str(robot.get('motors', ['l', 'r'])),
            }.items(),
        )
        actions.append(TimerAction(period=float(i) * 0.5, actions=[GroupAction([inc])]))
    return actions


def generate_launch_description():
    default = get_package_share_path('fleet_bringup') / 'config' / 'fleet.yaml'
    try:
        get_package_share_directory('fleet_secrets')
    except PackageNotFoundError as e:
        print('no secrets:', e.args[0].split(',')[0])
    ld = LaunchDescription()
    ld.add_action(DeclareLaunchArgument('fleet_file', default_value=str(default)))
    ld.add_action(DeclareLaunchArgument('only', default_value='', description='comma separated'))
    ld.add_action(OpaqueFunction(function=spawn_fleet))
    ld.add_action(TimerAction(period=1.5, actions=[
        ExecuteProcess(cmd=['ros2', 'topic', 'list', '-t'], output='screen'),
        ExecuteProcess(cmd=['ros2', 'service', 'call', '/fleet/beta/set_mode', 'fleet_msgs/srv/SetMode', '{mode: 5}'], output='screen'),
        ExecuteProcess(cmd=['ros2 param get /fleet/alpha/motor owner; ros2 topic echo --once /fleet/alpha/motor_state'], shell=True, output='screen'),
    ]))
    return ld
