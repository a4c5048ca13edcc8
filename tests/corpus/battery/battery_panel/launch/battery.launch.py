from launch import LaunchDescription
from launch.actions import TimerAction
from launch_ros.actions import Node


def generate_launch_description():
    ld = LaunchDescription()
    ld.add_action(Node(package='battery_panel', executable='battery'))
    ld.add_action(Node(package='battery_panel', executable='battery', name='second_battery', parameters=[{'led': 7}]))
    ld.add_action(TimerAction(period=5.5, actions=[
        Node(package='battery_panel', executable='panel', parameters=[{'leds': [True, False, False, False]}])]))
    return ld
