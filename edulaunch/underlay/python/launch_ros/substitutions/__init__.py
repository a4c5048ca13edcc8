"""Substitutions that look things up in packages and among global parameters."""

from launch._lazy import lazy_exports

_EXPORTS = {
    'ExecutableInPackage': 'executable_in_package',
    'FindPackage': 'find_package',
    'FindPackagePrefix': 'find_package',
    'FindPackageShare': 'find_package',
    'Parameter': 'parameter',
}
__all__ = list(_EXPORTS)
__getattr__, __dir__ = lazy_exports(__name__, _EXPORTS)
