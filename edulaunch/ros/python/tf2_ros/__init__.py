"""tf2 for nodes: the buffer, the listener and the broadcasters. Every name of ROS 2's package is loaded when it is first used."""

from __future__ import annotations

import sys
from importlib import import_module
from typing import Any

_HOMES = {
    'BufferCore': 'tf2_py',
    'ConnectivityException': 'tf2_py',
    'ExtrapolationException': 'tf2_py',
    'InvalidArgumentException': 'tf2_py',
    'LookupException': 'tf2_py',
    'TimeoutException': 'tf2_py',
    'TransformException': 'tf2_py',
    'Buffer': 'tf2_ros.buffer',
    'BufferClient': 'tf2_ros.buffer_client',
    'BufferInterface': 'tf2_ros.buffer_interface',
    'ConvertRegistration': 'tf2_ros.buffer_interface',
    'NotImplementedException': 'tf2_ros.buffer_interface',
    'Stamped': 'tf2_ros.buffer_interface',
    'TransformRegistration': 'tf2_ros.buffer_interface',
    'TypeException': 'tf2_ros.buffer_interface',
    'convert': 'tf2_ros.buffer_interface',
    'StaticTransformBroadcaster': 'tf2_ros.static_transform_broadcaster',
    'TransformBroadcaster': 'tf2_ros.transform_broadcaster',
    'TransformListener': 'tf2_ros.transform_listener',
}
"""The module that defines each name."""
_MODULES = (
    'buffer',
    'buffer_client',
    'buffer_interface',
    'static_transform_broadcaster',
    'transform_broadcaster',
    'transform_listener',
)
__all__ = sorted(_HOMES)  # noqa: PLE0605


def __getattr__(name: str) -> Any:
    if name in _HOMES:
        value = getattr(import_module(_HOMES[name]), name)
    elif name in _MODULES:
        value = import_module(f'tf2_ros.{name}')
    else:
        value = _of_a_module(name)
    setattr(sys.modules[__name__], name, value)
    return value


def _of_a_module(name: str) -> Any:
    """Return a name of one of the modules. ROS 2 exports all names of its modules, so `from tf2_ros import TransformStamped`
    works.
    """
    if not name.startswith('_'):
        for module in _MODULES:
            found = import_module(f'tf2_ros.{module}')
            if hasattr(found, name):
                return getattr(found, name)
    raise AttributeError(f'module {__name__!r} has no attribute {name!r}')


def __dir__() -> list[str]:
    return [*__all__, *_MODULES]
