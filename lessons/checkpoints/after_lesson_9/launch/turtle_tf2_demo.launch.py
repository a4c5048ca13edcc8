from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, ExecuteProcess
from launch.conditions import IfCondition
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def mine(executable, name, **parameters):
    return Node(package='learning_tf2_py', executable=executable, name=name, parameters=[parameters])


def generate_launch_description():
    drive = ['ros2', 'topic', 'pub', '--rate', '10', '--node-name', 'driver', '/turtle1/cmd_vel',
             'geometry_msgs/msg/Twist', '{linear: {x: 1.0}, angular: {z: 0.5}}']
    return LaunchDescription([
        DeclareLaunchArgument('target_frame', default_value='turtle1', description='The frame to follow.'),
        DeclareLaunchArgument('drive', default_value='true', description='false: you drive turtle1.'),
        Node(package='turtlesim', executable='turtlesim_node', name='sim'),
        ExecuteProcess(cmd=drive, condition=IfCondition(LaunchConfiguration('drive'))),
        mine('turtle_spawner', 'spawner'),
        mine('turtle_tf2_broadcaster', 'broadcaster1', turtlename='turtle1'),
        mine('turtle_tf2_broadcaster', 'broadcaster2', turtlename='turtle2'),
        mine('turtle_tf2_listener', 'listener', target_frame=LaunchConfiguration('target_frame')),
    ])
