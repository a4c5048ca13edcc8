"""Help for a misspelt message field.

`twist.linaer = 1` must raise Python's own AttributeError, as with real rclpy. A hook that adds to its text at
that moment (`__setattr__`) would make each correct assignment three times slower, so whoever reports an error
to the user asks here for the line to add.
"""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from edulaunch.interfaces.message import Message
from edulaunch.nearest import nearest

if TYPE_CHECKING:
    from edulaunch.interfaces.registry import Registry

_TEXT = re.compile(r"'(?P<type>\w+)' object has no attribute '(?P<name>\w+)'", re.ASCII)


def attribute_help(error: BaseException, registry: Registry) -> str | None:
    """One line of help for an AttributeError about a message, else None: "a Twist has linear and angular; did
    you mean 'linear'?".

    :param registry: its classes made so far are searched by name, since Python before 3.13 does not tell the
        object.
    """
    match = _TEXT.match(str(error)) if isinstance(error, AttributeError) else None
    if match is None:
        return None
    classes = _candidates(error, match['type'], registry)
    if not classes:
        return None
    name = match['name']
    for cls in classes:
        field = nearest(name, cls._FIELDS)
        if field is not None:
            return f"did you mean '{field}'?"
    fields = classes[0]._FIELDS
    return f'the fields of {classes[0].__name__} are: {", ".join(fields)}' if fields else f'{classes[0].__name__} has no fields'


def _candidates(error: BaseException, name: str, registry: Registry) -> list[type[Message]]:
    owner = getattr(error, 'obj', None)
    if owner is not None:
        return [type(owner)] if isinstance(owner, Message) else []
    return [cls for cls in registry.classes() if issubclass(cls, Message) and cls.__name__ == name]
