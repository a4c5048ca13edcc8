"""tf2 for nodes: buffer, listener, broadcasters. All names of upstream's package, loaded when they are first
used.
"""

from __future__ import annotations

import sys
from importlib import import_module
from typing import Any

_NAMES = {
    'tf2_py': (
        'BufferCore ConnectivityException ExtrapolationException InvalidArgumentException LookupException TimeoutException '
        'TransformException'
    ),
    'tf2_ros.buffer': 'Buffer',
    'tf2_ros.buffer_client': 'BufferClient',
    'tf2_ros.buffer_interface': (
        'BufferInterface ConvertRegistration NotImplementedException Stamped TransformRegistration TypeException convert'
    ),
    'tf2_ros.static_transform_broadcaster': 'StaticTransformBroadcaster',
    'tf2_ros.transform_broadcaster': 'TransformBroadcaster',
    'tf2_ros.transform_listener': 'TransformListener',
}
"""Module -> the names that are taken from it, with blanks between."""
_EXPORTS = {name: module for module, names in _NAMES.items() for name in names.split()}
_MODULES = [module.partition('.')[2] for module in _NAMES if module.startswith('tf2_ros.')]
__all__ = sorted(_EXPORTS)  # noqa: PLE0605


def __getattr__(name: str) -> Any:
    if name in _EXPORTS:
        value = getattr(import_module(_EXPORTS[name]), name)
    elif name in _MODULES:
        value = import_module(f'tf2_ros.{name}')
    else:
        value = _of_a_module(name)
    setattr(sys.modules[__name__], name, value)
    return value


def _of_a_module(name: str) -> Any:
    """Upstream takes in whatever its modules have, so `from tf2_ros import TransformStamped` works."""
    if not name.startswith('_'):
        for module in _MODULES:
            found = import_module(f'tf2_ros.{module}')
            if hasattr(found, name):
                return getattr(found, name)
    raise AttributeError(f'module {__name__!r} has no attribute {name!r}')


def __dir__() -> list[str]:
    return [*__all__, *_MODULES]
