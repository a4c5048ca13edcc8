"""Fields of messages by path, in the form of `ros2 topic echo --field`: 'pose.position.x', 'ranges[0]'."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from typing import Any

from edulaunch.engine.recording.absent import not_recorded

_STEP = re.compile(r'([A-Za-z_]\w*)((?:\[-?\d+\])*)')


def getter(cls: Any, path: str) -> Callable[[Any], Any]:
    """Return a function that reads a field from messages of a class.

    :param path: the path of the field.
    :raises NotRecorded: if the type has no such field; the message names the nearest field.
    :raises ValueError: if the path is malformed.
    """
    steps = path.split('.')
    found = [_STEP.fullmatch(step) for step in steps]
    if not all(found):
        raise ValueError(f"{path!r} is not a path of a field: write it as 'pose.position.x' or 'ranges[0]'")
    plain = '.'.join(match[1] for match in found if match)
    names = leaf_paths(cls)
    if plain not in names and not any(name.startswith(f'{plain}.') or plain.startswith(f'{name}.') for name in names):
        raise not_recorded(f'{cls.TYPE} has no field {plain!r}', plain, names)
    takes = [(match[1], [int(number) for number in re.findall(r'-?\d+', match[2])]) for match in found if match]

    def get(message: Any) -> Any:
        for name, numbers in takes:
            message = getattr(message, name)
            for number in numbers:
                message = _element(message, number, path)
        return message

    return get


def _element(values: Sequence[Any], number: int, path: str) -> Any:
    try:
        return values[number]
    except IndexError:
        raise not_recorded(f'{path!r} has no element {number}, only {len(values)} of them', path, ()) from None


def leaf_paths(cls: Any) -> list[str]:
    """Return the paths of all fields that are not messages."""
    return [path for path, _ in cls.wire_type()]
