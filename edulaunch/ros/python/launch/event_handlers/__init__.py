"""Handlers for the usual events."""

from .._lazy import lazy_exports

_EXPORTS = {
    'general': 'OnActionEventBase OnExecutionComplete OnIncludeLaunchDescription OnShutdown event_named',
    'processes': 'OnProcessExit OnProcessIO OnProcessStart',
}
__getattr__, __dir__ = lazy_exports(__name__, _EXPORTS)
