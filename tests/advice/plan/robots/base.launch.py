"""A mobile base: hardware driver, odometry filter, joystick, description from xacro, and a lamp that blinks only after the driver is up."""
from launch import LaunchDescription
from launch.actions import (
    DeclareLaunchArgument,
    EmitEvent,
    ExecuteProcess,
    LogInfo,
    RegisterEventHandler,
    SetEnvironmentVariable,
    TimerAction,
)
from launch.conditions import IfCondition, UnlessCondition
from launch.event_handlers import OnProcessExit, OnProcessStart
from launch.events import Shutdown
from launch.substitutions import (
    AndSubstitution,
    Command,
    EnvironmentVariable,
    EqualsSubstitution,
    IfElseSubstitution,
    LaunchConfiguration,
    NotSubstitution,
    PathJoinSubstitution,
)
from launch_ros.actions import Node, SetRemap
from launch_ros.descriptions import ParameterValue
from launch_ros.substitutions import FindPackageShare


def generate_launch_description():
    model = LaunchConfiguration('model')
    simulated = LaunchConfiguration('sim')
    folder = FindPackageShare('acme_base_description')
    description = ParameterValue(Command(['/bin/echo ', PathJoinSubstitution([folder, 'urdf', model]), '.urdf']), value_type=str)
    driver = Node(
        package='acme_base_driver', executable='base_node', name='base', output='both', emulate_tty=True,
        condition=UnlessCondition(simulated),
        parameters=[PathJoinSubstitution([folder, 'config', 'base.yaml']),
                    {'port': EnvironmentVariable('ACME_PORT', default_value='/dev/ttyACM0'), 'wheel': {'radius': 0.0825, 'ticks': 4096}}],
        arguments=['--ros-args', '--log-level', IfElseSubstitution(LaunchConfiguration('verbose'), 'debug', 'warn')])
    joystick = Node(package='joy', executable='joy_node', namespace='teleop', sigterm_timeout='2', respawn=True, respawn_delay=1.5,
                    condition=IfCondition(AndSubstitution(LaunchConfiguration('joystick'), NotSubstitution(simulated))))
    lamp = ExecuteProcess(cmd=['/bin/sh', '-c', 'exit 0'], name='lamp', additional_env={'LAMP': model})
    return LaunchDescription([
        DeclareLaunchArgument('model', default_value='mk2', choices=['mk1', 'mk2'], description='hardware generation'),
        DeclareLaunchArgument('sim', default_value='false'),
        DeclareLaunchArgument('joystick', default_value='on'),
        DeclareLaunchArgument('verbose', default_value='0'),
        SetEnvironmentVariable('ACME_MODEL', model),
        SetRemap('cmd_vel', 'base/cmd_vel'),
        driver,
        joystick,
        Node(package='robot_state_publisher', executable='robot_state_publisher', parameters=[{'robot_description': description}]),
        Node(package='robot_localization', executable='ekf_node', name='ekf', remappings=[('odometry/filtered', 'odom')],
             condition=IfCondition(EqualsSubstitution(model, 'mk2'))),
        RegisterEventHandler(OnProcessStart(target_action=driver, on_start=[TimerAction(period=2.0, actions=[lamp])])),
        RegisterEventHandler(OnProcessExit(target_action=driver, on_exit=[
            LogInfo(msg='the base driver is gone'), EmitEvent(event=Shutdown(reason='base driver exited'))])),
    ])
