"""Managed sensors: configured at the start, activated when they are ready, and the rest begins when the last one is active."""
import lifecycle_msgs.msg
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, EmitEvent, LogInfo, RegisterEventHandler, Shutdown
from launch.event_handlers import OnProcessExit
from launch.events import matches_action
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import LifecycleNode, Node
from launch_ros.event_handlers import OnStateTransition
from launch_ros.events.lifecycle import ChangeState
from launch_ros.parameter_descriptions import ParameterFile
from launch_ros.substitutions import FindPackageShare

Transition = lifecycle_msgs.msg.Transition


def managed(name, *more):
    node = LifecycleNode(package='acme_sensors', executable=name, name=name, namespace=LaunchConfiguration('ns'), output='screen',
                         parameters=[ParameterFile([FindPackageShare('acme_sensors'), '/config/', name, '.yaml']), {'rate': 10}])
    configure = EmitEvent(event=ChangeState(lifecycle_node_matcher=matches_action(node), transition_id=Transition.TRANSITION_CONFIGURE))
    activate = EmitEvent(event=ChangeState(lifecycle_node_matcher=matches_action(node), transition_id=Transition.TRANSITION_ACTIVATE))
    return [
        RegisterEventHandler(OnStateTransition(target_lifecycle_node=node, start_state='configuring', goal_state='inactive',
                                               entities=[LogInfo(msg=f'{name} is configured'), activate])),
        RegisterEventHandler(OnStateTransition(target_lifecycle_node=node, goal_state='active', entities=list(more))),
        node, configure]


def generate_launch_description():
    fusion = Node(package='acme_sensors', executable='fusion', name='fusion', on_exit=[Shutdown(reason='fusion ended')])
    recorder = Node(package='acme_sensors', executable='recorder', exec_name='tape', cwd='/tmp', prefix=['nice -n ', '10'], shell=True)
    return LaunchDescription([
        DeclareLaunchArgument('ns', default_value='sensors'),
        *managed('imu'),
        *managed('gps', fusion),
        recorder,
        RegisterEventHandler(OnProcessExit(target_action=recorder, on_exit=lambda event, context: LogInfo(msg='the tape is full'))),
    ])
