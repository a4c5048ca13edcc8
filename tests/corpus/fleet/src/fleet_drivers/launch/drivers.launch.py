"""Starts the drivers of one robot."""
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, GroupAction, LogInfo, OpaqueFunction, RegisterEventHandler, SetEnvironmentVariable
from launch.conditions import IfCondition, UnlessCondition
from launch.event_handlers import OnProcessExit, OnProcessStart
from launch.substitutions import (AndSubstitution, EnvironmentVariable, EqualsSubstitution, IfElseSubstitution, LaunchConfiguration,
                                  NotSubstitution, PathJoinSubstitution, PythonExpression, TextSubstitution)
from launch_ros.actions import Node, PushRosNamespace, SetParameter, SetRemap
from launch_ros.parameter_descriptions import ParameterFile, ParameterValue
from launch_ros.substitutions import FindPackageShare

ARGS = [
    DeclareLaunchArgument('robot', description='name of the robot'),
    DeclareLaunchArgument('namespace', default_value=[TextSubstitution(text='fleet/'), LaunchConfiguration('robot')]),
    DeclareLaunchArgument('simulate', default_value='true', choices=['true', 'false', 'auto']),
    DeclareLaunchArgument('with_bms', default_value='True'),
    DeclareLaunchArgument('log_level', default_value=EnvironmentVariable('FLEET_LOG', default_value='info')),
    DeclareLaunchArgument('motor_names', default_value="['left', 'right']"),
]


def make_selftest(context, *args, **kwargs):
    robot = LaunchConfiguration('robot').perform(context)
    if context.launch_configurations.get('simulate') == 'auto':
        return [LogInfo(msg=f'{robot}: auto, no selftest')]
    node = Node(package='fleet_drivers', executable='selftest', name=f'{robot}_selftest', output='screen')
    return [node, RegisterEventHandler(OnProcessExit(target_action=node, on_exit=lambda event, ctx: LogInfo(msg=f'{robot}: selftest returned {event.returncode}')))]


def generate_launch_description():
    robot = LaunchConfiguration('robot')
    params = ParameterFile(PathJoinSubstitution([FindPackageShare('fleet_drivers'), 'config', 'motor.yaml']), allow_substs=True)
    motor = Node(
        package='fleet_drivers', executable='motor', output='screen',
        parameters=[params, {
            'robot_name': robot,
            'motors': ParameterValue(LaunchConfiguration('motor_names')),
            'debug': EqualsSubstitution(LaunchConfiguration('log_level'), 'debug'),
            'simulate': ParameterValue(PythonExpression(["'", LaunchConfiguration('simulate'), "' in ('true', 'auto')"]), value_type=bool),
        }],
        remappings=[('e_stop', '/e_stop')],
        ros_arguments=['--log-level', LaunchConfiguration('log_level')],
        respawn=True, respawn_delay=1.0,
    )
    group = GroupAction([
        PushRosNamespace(LaunchConfiguration('namespace')),
        SetEnvironmentVariable('ROBOT_ID', robot),
        SetRemap(src='state', dst='motor_state'),
        SetParameter('owner', 'acme'),
        motor,
        OpaqueFunction(function=make_selftest),
        Node(package='fleet_drivers', executable='bms', output={'both': 'screen'}, on_exit=[LogInfo(msg='bms gone')],
             condition=IfCondition(AndSubstitution(LaunchConfiguration('with_bms'), NotSubstitution('false')))),
    ], scoped=True, forwarding=True)
    return LaunchDescription(ARGS + [
        LogInfo(msg=['starting ', robot, IfElseSubstitution(LaunchConfiguration('with_bms'), ' with', ' without'), ' bms']),
        LogInfo(msg='bms is off', condition=UnlessCondition(LaunchConfiguration('with_bms'))),
        RegisterEventHandler(OnProcessStart(target_action=motor, on_start=[LogInfo(msg='a motor is up')])),
        group,
    ])
