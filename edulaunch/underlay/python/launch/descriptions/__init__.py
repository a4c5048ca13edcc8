"""What actions execute, described apart from the actions."""

from .._lazy import lazy_exports

_EXPORTS = {'Executable': 'executable'}
__all__ = list(_EXPORTS)
__getattr__, __dir__ = lazy_exports(__name__, _EXPORTS)
