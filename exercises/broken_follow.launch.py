"""A teacher drives a circle, turtle1 copies it, turtle2 follows turtle1. Or so it should be.

    ros2 launch broken_follow.launch.py speed:=1.2

Nothing here is missing and nothing crashes, but three things are wrong: one name of a turtle, one name of a frame, and
one remapping that was forgotten. turtle1 does not move, and turtle2 does not either. The teacher's part is right.

ros2 reports no error for any of the three: nobody forbids to listen to a topic on which nobody talks, or to ask for a
frame that may still come. Find them with what the grader sees, or with ros2 topic list, ros2 node info and view_frames.

Grade it: edugrade exercises/broken_follow.launch.py        A hint: edugrade exercises/broken_follow.launch.py --hint 1
"""
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, ExecuteProcess
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def generate_launch_description():
    circle = ['{linear: {x: ', LaunchConfiguration('speed'), '}, angular: {z: 0.5}}']
    return LaunchDescription([
        DeclareLaunchArgument('speed', default_value='1.0', description="The teacher's speed (in m/s)."),

        # The teacher's world, and what makes the teacher drive.
        Node(package='turtlesim', executable='turtlesim_node', name='sim', namespace='teacher'),
        ExecuteProcess(
            cmd=['ros2', 'topic', 'pub', '/teacher/turtle1/cmd_vel', 'geometry_msgs/msg/Twist', circle],
        ),

        # TODO: three things are wrong from here on. Repair one, grade again, and see what changes.
        # The world of turtle1 and turtle2, and mimic, which lets turtle1 do what the teacher does.
        Node(package='turtlesim', executable='turtlesim_node', name='sim'),
        Node(
            package='turtlesim',
            executable='mimic',
            name='mimic',
            remappings=[
                ('input/pose', '/teacher/turtle1/pose'),
            ],
        ),

        # tf is told where both turtles are; turtle2 drives to turtle1.
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
