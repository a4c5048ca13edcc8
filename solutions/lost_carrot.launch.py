"""turtle2 should drive to a carrot, 2 m to the left of turtle1. Everything runs, but turtle2 does not move.

    ros2 launch lost_carrot.launch.py side:=2.0

There are two mistakes. Find them with the tools (tf2_echo, view_frames, edulaunch doctor) before you read the file.

Grade it with `edugrade exercises/lost_carrot.launch.py`. Add `--hint 1` for a hint.
"""
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def broadcaster(turtle):
    return Node(package='turtle_tf2_py', executable='turtle_tf2_broadcaster', name=f'broadcaster_{turtle}',
                parameters=[{'turtlename': turtle}])


def generate_launch_description():
    side = LaunchConfiguration('side')
    return LaunchDescription([
        DeclareLaunchArgument('side', default_value='2.0', description='Distance to the left, in metres.'),
        Node(package='turtlesim', executable='turtlesim_node', name='sim'),
        broadcaster('turtle1'),
        broadcaster('turtle2'),
        Node(package='tf2_ros', executable='static_transform_publisher', name='carrot',
             arguments=['--y', side, '--frame-id', 'turtle1', '--child-frame-id', 'carrot1']),
        Node(package='turtle_tf2_py', executable='turtle_tf2_listener', name='listener',
             parameters=[{'target_frame': 'carrot1'}]),
    ])
