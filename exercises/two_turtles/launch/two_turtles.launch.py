"""turtle2 should follow turtle1, but it does not move. One program broadcasts both turtles, and it is wrong.

    ros2 launch two_turtles two_turtles.launch.py turn:=0.4

There are two mistakes in two_turtles/broadcaster.py; this file is right. `ros2 run tf2_tools view_frames` shows the first one.
`ros2 run tf2_ros tf2_echo world turtle1`, compared with `ros2 topic echo /turtle1/pose`, shows the other one.

Grade it with `edugrade exercises/two_turtles`. Add `--hint 1` for a hint.
"""
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, ExecuteProcess
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def broadcaster(turtle):
    return Node(package='two_turtles', executable='broadcaster', name=f'{turtle}_broadcaster',
                parameters=[{'turtlename': turtle}])


def generate_launch_description():
    drive = ['ros2', 'topic', 'pub', '-r', '1', '/turtle1/cmd_vel', 'geometry_msgs/msg/Twist']
    return LaunchDescription([
        DeclareLaunchArgument('turn', default_value='0.4', description='Turning speed of turtle1, in radians per second.'),
        Node(package='turtlesim', executable='turtlesim_node', name='sim'),
        ExecuteProcess(cmd=[*drive, ['{linear: {x: 0.5}, angular: {z: ', LaunchConfiguration('turn'), '}}']]),
        broadcaster('turtle1'),
        broadcaster('turtle2'),
        Node(package='turtle_tf2_py', executable='turtle_tf2_listener', name='listener',
             parameters=[{'target_frame': 'turtle1'}]),
    ])
