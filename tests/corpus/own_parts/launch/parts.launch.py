import signal

from launch import LaunchDescription
from launch.actions import *
from launch.event_handlers import OnExecutionComplete, OnProcessExit, OnProcessIO, OnProcessStart, OnShutdown
from launch.events import matches_action
from launch.events.process import SignalProcess
from launch.substitutions import *
from launch_ros.actions import LifecycleNode, Node
from launch_ros.event_handlers import OnStateTransition
from launch_ros.events.lifecycle import ChangeState
from launch_ros.parameter_descriptions import ParameterFile
from launch_ros.substitutions import FindPackageShare
from lifecycle_msgs.msg import Transition
from own_parts.launch_parts.actions import Banner, Repeat, Upper, Weekday
from own_parts.launch_parts.rewritten_yaml import RewrittenYaml


def on_worker_io(event):
    for line in event.text.decode().splitlines():
        if 'ready' in line:
            return [LogInfo(msg='heard: ' + line)]


def generate_launch_description():
    config = PathJoinSubstitution([FindPackageShare('own_parts'), 'config', 'lidars.yaml'])
    rewritten = RewrittenYaml(source_file=config, rewrites={'rpm': LaunchConfiguration('rpm')}, convert_types=True)
    front, rear = (LifecycleNode(package='own_parts', executable='lidar', name=name, namespace='', output='screen',
                                 parameters=[ParameterFile(rewritten, allow_substs=True)]) for name in ('front', 'rear'))

    def change(node, transition):
        return EmitEvent(event=ChangeState(lifecycle_node_matcher=matches_action(node), transition_id=transition))

    worker = Node(package='own_parts', executable='worker', output='screen', parameters=[{'life': 1.2}],
                  additional_env={'WORKER_NO': LaunchConfiguration('number')}, respawn=True, respawn_delay=0.5, respawn_max_retries=1)
    timer = TimerAction(period=2.5, actions=[
        LogInfo(msg='ending front'),
        EmitEvent(event=SignalProcess(signal_number=signal.SIGTERM, process_matcher=matches_action(front)))])
    return LaunchDescription([
        DeclareLaunchArgument('rpm', default_value='600'),
        DeclareLaunchArgument('rear_device', default_value='ttyS1'),
        SetEnvironmentVariable('FRONT_PORT', '/dev/ttyACM0'),
        AppendEnvironmentVariable('FRONT_PORT', 'slow', separator=','),
        UnsetEnvironmentVariable('WEEKDAY'),
        SetLaunchConfiguration('number', '7'),
        Banner(text=['lidars of ', Upper(EnvironmentVariable('USER', default_value='nobody'))]),
        OpaqueFunction(function=lambda context: [LogInfo(msg='the banner was ' + context.launch_configurations['banner'])]),
        Repeat(LaunchConfiguration('times', default='2'), lambda i: LogInfo(msg=f'round {i}')),
        LogInfo(msg='a weekday', condition=Weekday()),
        RegisterEventHandler(OnProcessIO(target_action=worker, on_stderr=on_worker_io)),
        RegisterEventHandler(OnProcessStart(target_action=front, on_start=[change(front, Transition.TRANSITION_CONFIGURE)])),
        RegisterEventHandler(OnStateTransition(
            target_lifecycle_node=front, start_state='configuring', goal_state='inactive',
            entities=[LogInfo(msg='front is inactive'), change(front, Transition.TRANSITION_ACTIVATE)])),
        RegisterEventHandler(OnStateTransition(
            target_lifecycle_node=front, goal_state='active',
            entities=[ExecuteProcess(cmd=['ros2', 'lifecycle', 'set', '/rear', 'configure'], output='screen'),
                      ExecuteProcess(cmd=['ros2', 'lifecycle', 'get'], output='screen')])),
        front, rear, worker,
        RegisterEventHandler(OnProcessExit(on_exit=lambda event, context: LogInfo(msg=f'{event.process_name} returned {event.returncode}'))),
        RegisterEventHandler(OnExecutionComplete(target_action=timer, on_completion=[LogInfo(msg='timer done')])),
        RegisterEventHandler(OnShutdown(on_shutdown=lambda event, context: LogInfo(msg=f'shutdown: {event.reason}'))),
        timer,
        TimerAction(period=4.0, actions=[Shutdown(reason='time is up')]),
    ])
