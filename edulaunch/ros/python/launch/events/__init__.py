"""The events of a running launch."""

from typing import TYPE_CHECKING

from .._late import late_names

if TYPE_CHECKING:
    from . import process as process
    from .execution_complete import ExecutionComplete as ExecutionComplete
    from .include_launch_description import IncludeLaunchDescription as IncludeLaunchDescription
    from .matchers import matches_action as matches_action
    from .shutdown import Shutdown as Shutdown
    from .timer_event import TimerEvent as TimerEvent
else:
    __all__, __getattr__, __dir__ = late_names(
        __name__,
        {
            'ExecutionComplete': 'execution_complete',
            'IncludeLaunchDescription': 'include_launch_description',
            'Shutdown': 'shutdown',
            'TimerEvent': 'timer_event',
            'matches_action': 'matchers',
        },
        modules=('process',),
    )
