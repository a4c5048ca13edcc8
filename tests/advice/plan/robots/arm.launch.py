"""A manipulator in the manner of ros2_control: a robot description from xacro, controllers that are spawned one after the other."""
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, EmitEvent, RegisterEventHandler, TimerAction
from launch.conditions import UnlessCondition
from launch.event_handlers import OnProcessExit, OnProcessStart
from launch.events import Shutdown
from launch.substitutions import Command, FindExecutable, LaunchConfiguration, PathJoinSubstitution
from launch_ros.actions import Node
from launch_ros.parameter_descriptions import ParameterValue
from launch_ros.substitutions import FindPackageShare


def generate_launch_description():
    description = ParameterValue(Command([
        FindExecutable(name='xacro'), ' ', PathJoinSubstitution([FindPackageShare('acme_arm_description'), 'urdf', 'arm.urdf.xacro']),
        ' prefix:=', LaunchConfiguration('prefix')]), value_type=str)
    controllers = PathJoinSubstitution([FindPackageShare('acme_arm_bringup'), 'config', 'controllers.yaml'])
    control = Node(package='controller_manager', executable='ros2_control_node', parameters=[controllers], output='both')
    state = Node(package='controller_manager', executable='spawner', name='spawn_state', arguments=['joint_state_broadcaster'])
    arm = Node(package='controller_manager', executable='spawner', name='spawn_arm',
               arguments=['arm_controller', '--param-file', controllers])
    rviz = Node(package='rviz2', executable='rviz2', name='rviz2', condition=UnlessCondition(LaunchConfiguration('headless')),
                arguments=['-d', PathJoinSubstitution([FindPackageShare('acme_arm_description'), 'rviz', 'arm.rviz'])])
    return LaunchDescription([
        DeclareLaunchArgument('prefix', default_value='left_'),
        DeclareLaunchArgument('headless', default_value='true', choices=['true', 'false']),
        Node(package='robot_state_publisher', executable='robot_state_publisher', parameters=[{'robot_description': description}]),
        control,
        RegisterEventHandler(OnProcessStart(target_action=control, on_start=[TimerAction(period=1.0, actions=[state])])),
        RegisterEventHandler(OnProcessExit(target_action=state, on_exit=[arm])),
        RegisterEventHandler(OnProcessExit(target_action=rviz, on_exit=[EmitEvent(event=Shutdown(reason='window closed'))])),
        rviz,
    ])
