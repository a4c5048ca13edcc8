"""ROS 2 launch_testing: tests of a running launch description.

A launch test file describes what to launch (`generate_test_description`) and tests it with unittest classes: while it
runs, and after it was shut down. Names and rules are those of launch_testing in ROS 2 Jazzy; time is simulated, so that
`assertWaitFor(..., timeout=10)` gives the same answer on every machine.
"""

from launch._lazy import lazy_exports

from ._absent import ABSENT

_EXPORTS = {
    'ActiveIoHandler': 'io_handler',
    'ActiveProcInfoHandler': 'proc_info_handler',
    'IoHandler': 'io_handler',
    'ProcInfoHandler': 'proc_info_handler',
    **dict.fromkeys(('actions', 'asserts', 'event_handlers', 'io_handler', 'markers', 'proc_info_handler', 'tools', 'util'), ''),
}
_FILES = {'decorator': ('markers', 'parametrize'), 'io_handler': ('proc_info_handler',)}
__all__ = ['parametrize', 'post_shutdown_test', 'ready_to_test_action_timeout', *_EXPORTS]
__getattr__, __dir__ = lazy_exports(__name__, _EXPORTS, _FILES, ABSENT['all'])

from .decorator import parametrize, post_shutdown_test, ready_to_test_action_timeout  # noqa: E402
