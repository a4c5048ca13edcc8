"""Three programs that start one after the other.

    ros2 launch in_order.launch.py delay:=3.0

The simulator starts. When it has started, draw_square starts (its node name is driver). The launch argument delay is the
number of seconds between the start of draw_square and the start of the other simulator, /late/sim.

Grade it with `edugrade exercises/in_order.launch.py`. Add `--hint 1` for a hint.
"""
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, RegisterEventHandler, TimerAction
from launch.event_handlers import OnProcessStart
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def generate_launch_description():
    delay = LaunchConfiguration('delay')
    sim = Node(package='turtlesim', executable='turtlesim_node', name='sim')
    driver = Node(package='turtlesim', executable='draw_square', name='driver')
    late = Node(package='turtlesim', executable='turtlesim_node', name='sim', namespace='late')
    return LaunchDescription([
        DeclareLaunchArgument('delay', default_value='2.0', description='Seconds from the driver to the late world.'),
        # TODO 1: when sim has started, start driver

        # TODO 2: when driver has started, wait for delay, then start late

        sim,
    ])
