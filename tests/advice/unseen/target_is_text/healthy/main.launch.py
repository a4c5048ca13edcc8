from launch import LaunchDescription
from launch.actions import ExecuteProcess, RegisterEventHandler
from launch.event_handlers import OnProcessStart
from launch_ros.actions import Node


def generate_launch_description():
    sim = Node(package='turtlesim', executable='turtlesim_node', name='sim')
    call = ExecuteProcess(cmd=['ros2', 'service', 'call', '/clear', 'std_srvs/srv/Empty'])
    return LaunchDescription([RegisterEventHandler(OnProcessStart(target_action=sim, on_start=[call])), sim])
