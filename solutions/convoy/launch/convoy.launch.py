"""A row of turtles: turtle1 drives, turtle2 follows it, turtle3 follows turtle2, and so on.

    ros2 launch convoy convoy.launch.py count:=3

The launch argument count, 1 to 3, is the number of followers. Each follower drives to a carrot, 1 m behind the turtle in
front of it. follower.launch.py starts the parts of one follower and has the arguments me and leader. The node,
convoy/follower.py, is complete. No follower starts before the simulator has started. There are three gaps: one in
follower.launch.py, two here.

Grade it with `edugrade exercises/convoy`. Add `--hint 1` for a hint.
"""
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, ExecuteProcess, IncludeLaunchDescription, RegisterEventHandler
from launch.conditions import IfCondition
from launch.event_handlers import OnProcessStart
from launch.substitutions import LaunchConfiguration, PathJoinSubstitution, PythonExpression
from launch_ros.actions import Node
from launch_ros.substitutions import FindPackageShare

DRIVE = ['ros2', 'topic', 'pub', '-r', '10', '/turtle1/cmd_vel', 'geometry_msgs/msg/Twist']
PART = PathJoinSubstitution([FindPackageShare('convoy'), 'launch', 'follower.launch.py'])


def follower(number):
    wanted = PythonExpression([LaunchConfiguration('count'), f' >= {number - 1}'])
    names = {'me': f'turtle{number}', 'leader': f'turtle{number - 1}'}
    return IncludeLaunchDescription(PART, launch_arguments=names.items(), condition=IfCondition(wanted))


def generate_launch_description():
    sim = Node(package='turtlesim', executable='turtlesim_node', name='sim')
    row = [follower(number) for number in (2, 3, 4)]
    return LaunchDescription([
        DeclareLaunchArgument('count', default_value='1', choices=['1', '2', '3'], description='Number of followers.'),
        Node(package='turtle_tf2_py', executable='turtle_tf2_broadcaster', name='broadcaster_turtle1',
             parameters=[{'turtlename': 'turtle1'}]),
        ExecuteProcess(cmd=[*DRIVE, '{linear: {x: 1.0}, angular: {z: 0.4}}']),
        RegisterEventHandler(OnProcessStart(target_action=sim, on_start=row)),
        sim,
    ])
