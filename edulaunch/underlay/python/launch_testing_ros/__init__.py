"""ROS 2 launch_testing_ros: what tests of ROS nodes need beside launch_testing."""

from launch._lazy import lazy_exports
from launch_testing._absent import ABSENT

_EXPORTS = {'MessagePump': 'message_pump', 'WaitForTopics': 'wait_for_topics'}
__all__ = list(_EXPORTS)
__getattr__, __dir__ = lazy_exports(__name__, _EXPORTS, absent=ABSENT['ros'])
