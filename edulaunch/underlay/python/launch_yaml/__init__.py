"""Launch files in YAML."""

from launch._lazy import lazy_exports

_EXPORTS = {'Entity': 'entity', 'Parser': 'parser', 'launch_description_sources': ''}
__all__ = list(_EXPORTS)
__getattr__, __dir__ = lazy_exports(__name__, _EXPORTS)
