"""A teacher drives a circle, turtle1 should copy it, and turtle2 should follow turtle1.

    ros2 launch broken_follow.launch.py speed:=1.2

No node is missing and nothing crashes, but there are three mistakes: in the name of a turtle, in the name of a frame,
and in a remapping. Neither turtle1 nor turtle2 moves. The part of the teacher is right.

ROS 2 reports no error for any of the three: a node may subscribe to a topic without a publisher, and ask for a frame
that does not exist yet. Find them with the report of the grader, or with ros2 topic list, ros2 node info and view_frames.

Grade it with `edugrade exercises/broken_follow.launch.py`. Add `--hint 1` for a hint.
"""
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, ExecuteProcess
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def generate_launch_description():
    circle = ['{linear: {x: ', LaunchConfiguration('speed'), '}, angular: {z: 0.5}}']
    return LaunchDescription([
        DeclareLaunchArgument('speed', default_value='1.0', description="The teacher's speed (in m/s)."),

        # The teacher's world, and the command that drives the teacher.
        Node(package='turtlesim', executable='turtlesim_node', name='sim', namespace='teacher'),
        ExecuteProcess(
            cmd=['ros2', 'topic', 'pub', '/teacher/turtle1/cmd_vel', 'geometry_msgs/msg/Twist', circle],
        ),

        # TODO: there are three mistakes below. Repair one, grade again, and see what changes.
        # The world of turtle1 and turtle2, and mimic, which lets turtle1 copy the teacher.
        Node(package='turtlesim', executable='turtlesim_node', name='sim'),
        Node(
            package='turtlesim',
            executable='mimic',
            name='mimic',
            remappings=[
                ('input/pose', '/teacher/turtle1/pose'),
            ],
        ),

        # Two broadcasters for both turtles, and a listener that drives turtle2 to turtle1.
        Node(
            package='turtle_tf2_py',
            executable='turtle_tf2_broadcaster',
            name='broadcaster1',
            parameters=[{'turtlename': 'turtle1'}],
        ),
        Node(
            package='turtle_tf2_py',
            executable='turtle_tf2_broadcaster',
            name='broadcaster2',
            parameters=[{'turtlename': 'turtle_2'}],
        ),
        Node(
            package='turtle_tf2_py',
            executable='turtle_tf2_listener',
            name='listener',
            parameters=[{'target_frame': 'trutle1'}],
        ),
    ])
