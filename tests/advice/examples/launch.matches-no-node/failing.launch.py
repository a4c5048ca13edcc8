from launch import LaunchDescription
from launch.actions import EmitEvent, RegisterEventHandler, LogInfo
from launch_ros.actions import LifecycleNode
from launch_ros.events.lifecycle import ChangeState, matches_node_name
from launch_ros.event_handlers import OnStateTransition
from launch.events import matches_action
from lifecycle_msgs.msg import Transition

def generate_launch_description():
    talker = LifecycleNode(package='lifecycle', executable='lifecycle_talker', name='lc_talker', namespace='lab', output='screen')
    wake = RegisterEventHandler(OnStateTransition(target_lifecycle_node=talker, goal_state='inactive', entities=[
        LogInfo(msg='now activating'),
        EmitEvent(event=ChangeState(lifecycle_node_matcher=matches_action(talker), transition_id=Transition.TRANSITION_ACTIVATE))]))
    start = EmitEvent(event=ChangeState(lifecycle_node_matcher=matches_node_name('/lc_talker'), transition_id=Transition.TRANSITION_CONFIGURE))
    return LaunchDescription([wake, talker, start])
