"""Handlers for common events."""

from typing import TYPE_CHECKING

from .._late import late_names
from .event_named import event_named as event_named

if TYPE_CHECKING:
    from .on_action_event_base import OnActionEventBase as OnActionEventBase
    from .on_execution_complete import OnExecutionComplete as OnExecutionComplete
    from .on_include_launch_description import OnIncludeLaunchDescription as OnIncludeLaunchDescription
    from .on_process_exit import OnProcessExit as OnProcessExit
    from .on_process_io import OnProcessIO as OnProcessIO
    from .on_process_start import OnProcessStart as OnProcessStart
    from .on_shutdown import OnShutdown as OnShutdown
else:
    __all__, __getattr__, __dir__ = late_names(
        __name__,
        {
            'OnActionEventBase': 'on_action_event_base',
            'OnExecutionComplete': 'on_execution_complete',
            'OnIncludeLaunchDescription': 'on_include_launch_description',
            'OnProcessExit': 'on_process_exit',
            'OnProcessIO': 'on_process_io',
            'OnProcessStart': 'on_process_start',
            'OnShutdown': 'on_shutdown',
        },
        eager=('event_named',),
    )
