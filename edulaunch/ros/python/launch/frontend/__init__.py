"""Launch files in formats other than Python: what XML and YAML have in common, and how to extend both."""

from .._lazy import lazy_exports

_EXPORTS = {
    '': 'parse_substitution type_utils',
    'entity': 'Entity =type_utils',
    'expose': 'expose_action=expose expose_substitution=expose',
    'invalid_frontend_launch_file_error': 'InvalidFrontendLaunchFileError',
    'parser': 'Parser',
}
__getattr__, __dir__ = lazy_exports(__name__, _EXPORTS)
