from launch import LaunchDescription
from launch.actions import ExecuteProcess, RegisterEventHandler
from launch.event_handlers import OnProcessStart
from launch_ros.actions import Node


def generate_launch_description():
    sim = Node(package='turtlesim', executable='turtlesim_node')
    spawn = ExecuteProcess(
        cmd=['ros2', 'service', 'call', '/spawn', 'turtlesim/srv/Spawn', "{x: 2.0, y: 2.0, theta: 0.0, name: 'leo'}"]
    )
    return LaunchDescription([
        sim,
        spawn,
        RegisterEventHandler(OnProcessStart(target_action=sim, on_start=[spawn])),
    ])
