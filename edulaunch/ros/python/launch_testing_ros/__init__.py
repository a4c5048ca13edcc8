"""ROS 2 launch_testing_ros: what tests of ROS nodes need beside launch_testing."""

from launch._lazy import lazy_exports
from launch_testing._absent import ABSENT

__getattr__, __dir__ = lazy_exports(
    __name__, {'message_pump': 'MessagePump', 'wait_for_topics': 'WaitForTopics'}, absent=ABSENT['ros']
)
