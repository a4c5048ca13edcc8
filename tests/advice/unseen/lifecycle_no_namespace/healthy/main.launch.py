from launch import LaunchDescription
from launch.actions import EmitEvent, RegisterEventHandler
from launch.events import matches_action
from launch_ros.actions import LifecycleNode
from launch_ros.event_handlers import OnStateTransition
from launch_ros.events.lifecycle import ChangeState
from lifecycle_msgs.msg import Transition


def generate_launch_description():
    talker = LifecycleNode(package='robo', executable='talker', name='talker', namespace='', output='screen')
    return LaunchDescription([
        talker,
        EmitEvent(event=ChangeState(lifecycle_node_matcher=matches_action(talker), transition_id=Transition.TRANSITION_CONFIGURE)),
        RegisterEventHandler(OnStateTransition(target_lifecycle_node=talker, goal_state='inactive', entities=[
            EmitEvent(event=ChangeState(lifecycle_node_matcher=matches_action(talker), transition_id=Transition.TRANSITION_ACTIVATE)),
        ])),
    ])
