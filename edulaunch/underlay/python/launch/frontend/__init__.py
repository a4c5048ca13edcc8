"""Launch files in formats other than Python: what XML and YAML have in common, and how to extend both."""

from .._lazy import lazy_exports

_EXPORTS = {
    'Entity': 'entity',
    'InvalidFrontendLaunchFileError': 'invalid_frontend_launch_file_error',
    'Parser': 'parser',
    'expose_action': 'expose',
    'expose_substitution': 'expose',
    'parse_substitution': '',
    'type_utils': '',
}
_FILES = {'entity': ('type_utils',)}
__all__ = list(_EXPORTS)
__getattr__, __dir__ = lazy_exports(__name__, _EXPORTS, _FILES)
