from launch import LaunchDescription
from launch.actions import LogInfo, RegisterEventHandler
from launch.event_handlers import OnProcessIO
from launch_ros.actions import Node


def generate_launch_description():
    talker = Node(package='demo_nodes_py', executable='talker', output='screen')

    def heard(event):
        if event.text.find('Hello World: 3') >= 0:
            return [LogInfo(msg='three')]

    return LaunchDescription([
        talker,
        Node(package='demo_nodes_py', executable='listener'),
        RegisterEventHandler(OnProcessIO(target_action=talker, on_stderr=heard)),
    ])
