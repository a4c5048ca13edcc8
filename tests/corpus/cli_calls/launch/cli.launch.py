from launch import LaunchDescription
from launch.actions import ExecuteProcess, RegisterEventHandler, TimerAction
from launch.event_handlers import OnProcessExit, OnProcessStart
from launch_ros.actions import Node


def generate_launch_description():
    sim = Node(package='turtlesim', executable='turtlesim_node')
    spawn = ExecuteProcess(
        cmd=[['ros2 service call ', '/spawn ', 'turtlesim/srv/Spawn ',
              '"{x: 2, y: 2, theta: 0.2, name: \'leo\'}"']],
        shell=True)
    drive = ExecuteProcess(
        cmd=['ros2', 'topic', 'pub', '--times', '2', '/turtle1/cmd_vel', 'geometry_msgs/msg/Twist',
             '{linear: {x: 2.0, y: 0.0, z: 0.0}, angular: {x: 0.0, y: 0.0, z: 1.8}}'], output='log')
    turn = ExecuteProcess(
        cmd=['ros2', 'action', 'send_goal', '/leo/rotate_absolute', 'turtlesim/action/RotateAbsolute', '{theta: 0.5}'],
        output='screen', name='turn')
    colour = ExecuteProcess(cmd=['ros2', 'param', 'set', '/turtlesim', 'background_r', '120'], shell=True)
    nodes = ExecuteProcess(cmd=['ros2', 'node', 'list'], output='screen')
    return LaunchDescription([
        sim,
        Node(package='cli_calls', executable='listener'),
        RegisterEventHandler(OnProcessStart(target_action=sim, on_start=[spawn])),
        RegisterEventHandler(event_handler=OnProcessExit(target_action=spawn, on_exit=[
            TimerAction(period=1.0, actions=[drive]), turn])),
        RegisterEventHandler(OnProcessExit(target_action=turn, on_exit=nodes)),
        TimerAction(period=2.0, actions=[colour]),
    ])
