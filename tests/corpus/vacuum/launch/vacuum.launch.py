from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, ExecuteProcess, TimerAction
from launch.substitutions import LaunchConfiguration, PathJoinSubstitution
from launch_ros.actions import Node
from launch_ros.substitutions import FindPackageShare


def generate_launch_description():
    params = PathJoinSubstitution([FindPackageShare('vacuum'), 'config', 'vacuum.yaml'])
    samples = LaunchConfiguration('samples')
    return LaunchDescription([
        DeclareLaunchArgument('samples', default_value='120', description='rays of the laser'),
        Node(package='vacuum', executable='base', parameters=[params], remappings=[('~/odom', 'odom')], output='screen'),
        Node(package='vacuum', executable='lidar', parameters=[params, {'samples': samples}], output='both'),
        Node(package='vacuum', executable='brain', output='screen'),
        Node(package='vacuum', executable='mapper', output='screen'),
        TimerAction(period=2.5, actions=[
            ExecuteProcess(cmd=['ros2 topic echo --once --field info.width /map && ros2 service call /base/reset std_srvs/srv/Empty'],
                           shell=True, output='screen'),
        ]),
    ])
