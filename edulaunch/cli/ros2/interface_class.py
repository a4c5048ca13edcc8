"""From the name of a type, as a command line gives it, to its class."""

from __future__ import annotations

from typing import Any

from edulaunch.errors import InterfaceError
from edulaunch.interfaces import current_registry


def interface_class(text: str, kind: str) -> Any:
    """The class of 'pkg/msg/Name' (`kind` 'msg', 'srv' or 'action'; the short form 'pkg/Name' will do).

    :raises InterfaceError: when there is no such type; its help names the nearest one.
    """
    parts = text.split('/')
    if len(parts) == 2:
        parts.insert(1, kind)
    name = '/'.join(parts)
    if len(parts) != 3 or parts[1] != kind:
        raise InterfaceError(f'{text!r} is no {kind} type', help=f'write it as in {EXAMPLES[kind]}')
    return current_registry().get(name)


EXAMPLES = {'msg': 'geometry_msgs/msg/Twist', 'srv': 'turtlesim/srv/Spawn', 'action': 'turtlesim/action/RotateAbsolute'}
