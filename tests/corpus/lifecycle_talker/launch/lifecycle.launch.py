from launch import LaunchDescription
from launch.actions import EmitEvent, RegisterEventHandler, TimerAction
from launch.events import matches_action
from launch_ros.actions import LifecycleNode, Node
from launch_ros.event_handlers import OnStateTransition
from launch_ros.events.lifecycle import ChangeState
import lifecycle_msgs.msg


def generate_launch_description():
    talker = LifecycleNode(package='lifecycle_talker', executable='talker', name='lc_talker', namespace='', output='screen')

    def change(transition):
        return EmitEvent(event=ChangeState(lifecycle_node_matcher=matches_action(talker), transition_id=transition))

    activate = RegisterEventHandler(OnStateTransition(
        target_lifecycle_node=talker, start_state='configuring', goal_state='inactive',
        entities=[TimerAction(period=1.2, actions=[change(lifecycle_msgs.msg.Transition.TRANSITION_ACTIVATE)])]))
    return LaunchDescription([
        talker,
        Node(package='lifecycle_talker', executable='listener'),
        activate,
        TimerAction(period=0.5, actions=[change(lifecycle_msgs.msg.Transition.TRANSITION_CONFIGURE)]),
        TimerAction(period=4.0, actions=[change(lifecycle_msgs.msg.Transition.TRANSITION_DEACTIVATE)]),
        TimerAction(period=5.0, actions=[change(lifecycle_msgs.msg.Transition.TRANSITION_CLEANUP)]),
    ])
