"""turtle2 should follow turtle1, and stands still: one program tells tf2 about both turtles, and something is wrong in it.

    ros2 launch two_turtles two_turtles.launch.py turn:=0.4

Two places are wrong in two_turtles/broadcaster.py; this file is right. `ros2 run tf2_tools view_frames` shows the first one,
and `ros2 run tf2_ros tf2_echo world turtle1`, beside `ros2 topic echo /turtle1/pose`, the other one.

Grade it: edugrade exercises/two_turtles        A hint: edugrade exercises/two_turtles --hint 1
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
        DeclareLaunchArgument('turn', default_value='0.4', description='How fast turtle1 turns, in radians per second.'),
        Node(package='turtlesim', executable='turtlesim_node', name='sim'),
        ExecuteProcess(cmd=[*drive, ['{linear: {x: 0.5}, angular: {z: ', LaunchConfiguration('turn'), '}}']]),
        broadcaster('turtle1'),
        broadcaster('turtle2'),
        Node(package='turtle_tf2_py', executable='turtle_tf2_listener', name='listener',
             parameters=[{'target_frame': 'turtle1'}]),
    ])
