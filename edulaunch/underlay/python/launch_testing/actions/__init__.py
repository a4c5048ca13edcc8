"""Actions for launch tests."""

from launch._lazy import lazy_exports

_EXPORTS = {'GTest': 'gtest', 'PyTest': 'pytest', 'ReadyToTest': 'ready', 'Test': 'test'}
__all__ = list(_EXPORTS)
__getattr__, __dir__ = lazy_exports(__name__, _EXPORTS)
