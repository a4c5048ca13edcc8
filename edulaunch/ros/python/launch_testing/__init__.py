"""ROS 2 launch_testing: tests of a running launch description.

A launch test file describes what to launch (`generate_test_description`) and tests it with unittest classes: while it
runs, and after it was shut down. Names and rules are those of launch_testing in ROS 2 Jazzy; time is simulated, so that
`assertWaitFor(..., timeout=10)` gives the same answer on every machine.
"""

from launch._lazy import lazy_exports

from ._absent import ABSENT

_EXPORTS = {
    '': 'actions asserts event_handlers io_handler markers proc_info_handler tools util',
    'decorator': '=markers =parametrize',
    'io_handler': 'ActiveIoHandler=io_handler ActiveProcInfoHandler=proc_info_handler IoHandler ProcInfoHandler',
}
__all__ = ['parametrize', 'post_shutdown_test', 'ready_to_test_action_timeout']
__getattr__, __dir__ = lazy_exports(__name__, _EXPORTS, ABSENT['all'])

from .decorator import parametrize, post_shutdown_test, ready_to_test_action_timeout  # noqa: E402
