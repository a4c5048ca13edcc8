"""What is known about a misspelt message field.

`twist.linaer = 1` must raise Python's own AttributeError, as with real rclpy. A hook that adds to its text at
that moment (`__setattr__`) would make each correct assignment three times slower, so whoever reports an error
to the user asks here for what it does not say.
"""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Any

from edulaunch.interfaces.message import Message
from edulaunch.nearest import nearest

if TYPE_CHECKING:
    from edulaunch.interfaces.registry import Registry

_TEXT = re.compile(r"'(?P<type>\w+)' object has no attribute '(?P<name>\w+)'", re.ASCII)


def field_facts(error: BaseException, registry: Registry) -> dict[str, Any]:
    """Facts of an AttributeError about a message: its type and its fields; of any other error none.

    :param registry: its classes made so far are searched by name, since Python before 3.13 does not tell the
        object.
    """
    match = _TEXT.match(str(error)) if isinstance(error, AttributeError) else None
    if match is None:
        return {}
    classes = _candidates(error, match['type'], registry)
    if not classes:
        return {}
    name = match['name']
    near = next(filter(None, (nearest(name, cls._FIELDS) for cls in classes)), None)
    type_name = classes[0].__name__
    return {'about': 'messages.field', 'type': type_name, 'field': name, 'near': near, 'fields': list(classes[0]._FIELDS)}


def _candidates(error: BaseException, name: str, registry: Registry) -> list[type[Message]]:
    owner = getattr(error, 'obj', None)
    if owner is not None:
        return [type(owner)] if isinstance(owner, Message) else []
    return [cls for cls in registry.classes() if issubclass(cls, Message) and cls.__name__ == name]
