"""Finds the launch file and the line that created an action.

ROS 2 does not record this place. Errors, `edulaunch doctor` and grades use it. Every action needs its place, so finding it must
take very little time. The search stores two numbers, and converts them to a readable form on request.
"""

from __future__ import annotations

import os
import sys
from types import CodeType, FrameType
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from edulaunch.engine.processes import Origin

FACES = os.path.dirname(os.path.dirname(os.path.abspath(__file__))) + os.sep
Place = tuple[str, int] | tuple[CodeType, int]
"""A file and a line; or a code object and the last instruction, because finding the line takes time that grows with the file."""


class Inherited(tuple):  # type: ignore[type-arg]
    """The place of an action that launch itself created while it visited another action. The place of the other action
    is used.
    """


MAKERS: dict[int, CodeType] = {}
"""Code of edulaunch at which the search ends: the frontends' parser, which sets the origin of its actions, and a visit. The keys
are `id()`s, because the hash of a code object covers its whole content. For a launch file with thousands of nodes, that takes
longer than creating an action.
"""
_KEPT_TABLES = 64
_MOST_CALLS = 20
_TABLES: dict[int, tuple[CodeType, list[int], list[int]]] = {}
"""Line tables by the `id()` of their code object, which they keep alive."""


def caller_outside_launch(made: object) -> Place | None:
    """Return the place of the innermost running code that belongs neither to edulaunch nor to the constructor of `made`.

    An action that another action of edulaunch creates during its visit has the place of that other action. Return None if there
    is no such place. If functions of the same file led to the call, they are stored in `made`.
    """
    frame: FrameType | None = sys._getframe(2)
    while frame is not None:
        code = frame.f_code
        if code.co_filename.startswith(FACES):
            if id(code) in MAKERS:
                place: Place | None = getattr(frame.f_locals['self'], '_Action__origin', None)
                return None if place is None else Inherited(place)
        elif code.co_name != '__init__' or not _makes(code, frame, made):
            outer = frame.f_back
            if outer is not None and outer.f_code.co_filename == code.co_filename:
                made.__dict__['_Action__calls'] = _calls_around(frame)
            return code, frame.f_lasti
        frame = frame.f_back
    return None


def _calls_around(frame: FrameType) -> list[tuple[str, Place]]:
    """Return the functions around a frame that are called from their own file, each with the place of its call. The innermost is
    first.
    """
    found: list[tuple[str, Place]] = []
    file, outer = frame.f_code.co_filename, frame.f_back
    while outer is not None and outer.f_code.co_filename == file and len(found) < _MOST_CALLS:
        if not frame.f_code.co_name.startswith('<'):  # a comprehension is part of the function around it
            found.append((frame.f_code.co_name, (outer.f_code, outer.f_lasti)))
        frame, outer = outer, outer.f_back
    return found


def _makes(code: CodeType, frame: FrameType, made: object) -> bool:
    """Return whether the frame runs a constructor of exactly this object, such as that of a student's subclass."""
    return bool(code.co_argcount) and frame.f_locals.get(code.co_varnames[0]) is made


def origin_of(place: Place | None) -> Origin | None:
    """Return the engine's `Origin` for a place, or None if there is no place."""
    if place is None:
        return None
    from edulaunch.engine.processes import Origin

    where, position = place
    return Origin(where, position) if isinstance(where, str) else Origin(where.co_filename, _line_at(where, position))


def _line_at(code: CodeType, position: int) -> int:
    from bisect import bisect_right

    _, starts, lines = _TABLES.get(id(code)) or _line_table(code)
    return lines[bisect_right(starts, position) - 1]


def _line_table(code: CodeType) -> tuple[CodeType, list[int], list[int]]:
    rows = [(start, line) for start, _, line in code.co_lines() if line is not None]
    table = code, [start for start, _ in rows], [line for _, line in rows]
    if len(_TABLES) >= _KEPT_TABLES:
        _TABLES.clear()
    _TABLES[id(code)] = table
    return table


def note_origin(error: BaseException, entity: Any) -> None:
    """Store the origin and the class name of the innermost action that raised `error` on `error` itself.

    The attributes are `edulaunch_origin` and `edulaunch_entity`.
    """
    if not hasattr(error, 'edulaunch_origin'):
        error.edulaunch_origin = entity.origin  # type: ignore[attr-defined]
        error.edulaunch_entity = type(entity).__name__  # type: ignore[attr-defined]
