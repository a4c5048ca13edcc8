"""A recorder that starts before the driver, so that it records the whole drive.

    ros2 launch black_box.launch.py robot:=red

The recorder writes the topics cmd_vel and pose of the turtle into the bag my_drive. The driver starts only when the
recorder has started.

Grade it with `edugrade exercises/black_box.launch.py`. Add `--hint 1` for a hint.
"""
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, ExecuteProcess, RegisterEventHandler
from launch.event_handlers import OnProcessStart
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def generate_launch_description():
    robot = LaunchConfiguration('robot')
    drive = Node(package='turtlesim', executable='draw_square', namespace=robot)
    topics = [['/', robot, '/turtle1/cmd_vel'], ['/', robot, '/turtle1/pose']]
    recorder = ExecuteProcess(cmd=['ros2', 'bag', 'record', '-o', 'my_drive', *topics])
    return LaunchDescription([
        DeclareLaunchArgument('robot', default_value='red', description='The namespace of the world.'),
        Node(package='turtlesim', executable='turtlesim_node', name='sim', namespace=robot),
        RegisterEventHandler(OnProcessStart(target_action=recorder, on_start=[drive])),
        recorder,
    ])
