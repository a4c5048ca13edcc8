"""What can happen in a running launch."""

from .._lazy import lazy_exports

_EXPORTS = {
    'ExecutionComplete': 'execution_complete',
    'IncludeLaunchDescription': 'include_launch_description',
    'Shutdown': 'shutdown',
    'TimerEvent': 'timer_event',
    'matches_action': 'matchers',
    'process': '',
}
__all__ = list(_EXPORTS)
__getattr__, __dir__ = lazy_exports(__name__, _EXPORTS)
