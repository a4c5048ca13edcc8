"""ROS 2 launch_testing_ros: what tests of ROS nodes need beside launch_testing."""

from launch._lazy import lazy_exports

_EXPORTS = {
    'LaunchTestRunner': 'test_runner',
    'MessagePump': 'message_pump',
    'WaitForTopics': 'wait_for_topics',
    'test_runner': '',
}
_ABSENT = {
    'DataRepublisher': 'a subscription whose callback publishes does the same',
    'tools': 'they filter the output of a middleware, which there is none of; compare with proc_output.assertWaitFor',
}
__all__ = list(_EXPORTS)
__getattr__, __dir__ = lazy_exports(__name__, _EXPORTS, absent=_ABSENT)
