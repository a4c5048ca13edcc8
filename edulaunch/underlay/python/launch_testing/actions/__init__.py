"""Actions for launch tests."""

from launch._lazy import lazy_exports

_EXPORTS = {'ReadyToTest': 'ready'}
_PROCESS = 'launch a program with ExecuteProcess, and look at its exit code with launch_testing.asserts.assertExitCodes'
__all__ = list(_EXPORTS)
__getattr__, __dir__ = lazy_exports(__name__, _EXPORTS, absent=dict.fromkeys(('GTest', 'PyTest', 'Test'), _PROCESS))
