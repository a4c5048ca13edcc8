"""ROS 2 launch_testing_ros: additions to launch_testing for tests of ROS nodes."""

from typing import TYPE_CHECKING

from launch._late import late_names
from launch_testing._absent import ABSENT

if TYPE_CHECKING:
    from .message_pump import MessagePump as MessagePump
    from .wait_for_topics import WaitForTopics as WaitForTopics
else:
    __all__, __getattr__, __dir__ = late_names(
        __name__, {'MessagePump': 'message_pump', 'WaitForTopics': 'wait_for_topics'}, absent=ABSENT['ros']
    )
