"""Handlers for the usual events."""

from .._lazy import lazy_exports

_EXPORTS = {
    'OnActionEventBase': 'on_action_event_base',
    'OnExecutionComplete': 'on_execution_complete',
    'OnIncludeLaunchDescription': 'on_include_launch_description',
    'OnProcessExit': 'on_process_exit',
    'OnProcessIO': 'on_process_io',
    'OnProcessStart': 'on_process_start',
    'OnShutdown': 'on_shutdown',
    'event_named': 'event_named',
}
_FILES = {
    'general': ('event_named', 'on_action_event_base', 'on_execution_complete', 'on_include_launch_description', 'on_shutdown'),
    'processes': ('on_process_exit', 'on_process_io', 'on_process_start'),
}
__all__ = list(_EXPORTS)
__getattr__, __dir__ = lazy_exports(__name__, _EXPORTS, _FILES)
