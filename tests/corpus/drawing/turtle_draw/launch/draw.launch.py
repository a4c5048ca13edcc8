import os
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, RegisterEventHandler, EmitEvent, LogInfo, Shutdown
from launch.event_handlers import OnProcessExit
from launch.events import Shutdown as ShutdownEvent
from launch.substitutions import LaunchConfiguration, PythonExpression
from launch_ros.actions import Node


def generate_launch_description():
    config = os.path.join(get_package_share_directory('turtle_draw'), 'config', 'draw.yaml')
    sides = LaunchConfiguration('sides', default='5')
    client = Node(package='turtle_draw', executable='draw_client', output='screen', emulate_tty=True,
                  arguments=['--sides', sides, '--size', '2.5', '--cancel-after', LaunchConfiguration('cancel')])
    return LaunchDescription([
        DeclareLaunchArgument('sides', default_value='5', description='number of sides'),
        DeclareLaunchArgument('cancel', default_value='0'),
        Node(package='turtlesim', executable='turtlesim_node', name='sim'),
        Node(package='turtle_draw', executable='shape_server'),
        Node(package='turtle_draw', executable='draw_server', parameters=[config, {'kp_ang': 6.0}], output='screen'),
        client,
        RegisterEventHandler(OnProcessExit(target_action=client, on_exit=[
            LogInfo(msg=['client done; sides=', sides, ' even=', PythonExpression([sides, ' % 2 == 0'])]),
            EmitEvent(event=ShutdownEvent(reason='drawing finished'))])),
    ])
