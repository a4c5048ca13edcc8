"""Two new turtles; the user chooses the position of one of them.

    ros2 launch visitors.launch.py x:=3.0

When the simulator has started, call the service /spawn twice: for a turtle bert at (9, 9), and for a turtle carl at (x, 2).
The launch argument x is the x of carl. (A call is `ros2 service call NAME TYPE VALUES`.)

Grade it with `edugrade exercises/visitors.launch.py`. Add `--hint 1` for a hint.
"""
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, ExecuteProcess, RegisterEventHandler
from launch.event_handlers import OnProcessStart
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def spawn(*words):
    return ExecuteProcess(cmd=['ros2', 'service', 'call', '/spawn', 'turtlesim/srv/Spawn', list(words)])


def generate_launch_description():
    sim = Node(package='turtlesim', executable='turtlesim_node', name='sim')
    return LaunchDescription([
        DeclareLaunchArgument('x', default_value='3.0', description='The x of carl, in metres from the left.'),
        RegisterEventHandler(OnProcessStart(target_action=sim, on_start=[
            spawn('{x: 9.0, y: 9.0, name: bert}'),
            spawn('{x: ', LaunchConfiguration('x'), ', y: 2.0, name: carl}'),
        ])),
        sim,
    ])
