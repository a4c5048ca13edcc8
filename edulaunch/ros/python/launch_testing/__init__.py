"""ROS 2 launch_testing: tests of a running launch description.

A launch test file describes what to launch (`generate_test_description`), and tests the launch with unittest classes: while it
runs, and after its shutdown. The names and rules are those of launch_testing in ROS 2 Jazzy. Time is simulated, so
`assertWaitFor(..., timeout=10)` has the same result on every computer.
"""

from typing import TYPE_CHECKING

from launch._late import late_names

from ._absent import ABSENT
from .decorator import post_shutdown_test as post_shutdown_test
from .decorator import ready_to_test_action_timeout as ready_to_test_action_timeout
from .parametrize import parametrize as parametrize

if TYPE_CHECKING:
    from . import actions as actions
    from . import asserts as asserts
    from . import event_handlers as event_handlers
    from . import io_handler as io_handler
    from . import markers as markers
    from . import proc_info_handler as proc_info_handler
    from . import tools as tools
    from . import util as util
    from .io_handler import ActiveIoHandler as ActiveIoHandler
    from .io_handler import IoHandler as IoHandler
    from .proc_info_handler import ActiveProcInfoHandler as ActiveProcInfoHandler
    from .proc_info_handler import ProcInfoHandler as ProcInfoHandler
else:
    __all__, __getattr__, __dir__ = late_names(
        __name__,
        {
            'ActiveIoHandler': 'io_handler',
            'IoHandler': 'io_handler',
            'ActiveProcInfoHandler': 'proc_info_handler',
            'ProcInfoHandler': 'proc_info_handler',
        },
        modules=('actions', 'asserts', 'event_handlers', 'io_handler', 'markers', 'proc_info_handler', 'tools', 'util'),
        eager=('parametrize', 'post_shutdown_test', 'ready_to_test_action_timeout'),
        absent=ABSENT['all'],
    )
