"""Launch files in XML."""

from launch._lazy import lazy_exports

__getattr__, __dir__ = lazy_exports(__name__, {'': 'launch_description_sources', 'entity': 'Entity', 'parser': 'Parser'})
