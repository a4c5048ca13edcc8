"""Which line of which launch file made an action.

ROS 2 does not know this; errors, `edulaunch doctor` and grades point there. It must cost next to nothing,
because every action pays for it: two numbers are kept, and made readable only when somebody asks.
"""
from __future__ import annotations

import os
import sys
from functools import lru_cache
from types import CodeType, FrameType
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from edulaunch.processes import Origin

FACES = os.path.dirname(os.path.dirname(os.path.abspath(__file__))) + os.sep
Place = tuple[str, int] | tuple[CodeType, int]
"""File and line; or code, and how far it had run (finding the line takes time that grows with the file)."""

MAKERS: set[CodeType] = set()
"""Code of ours that says itself where the actions come from which it makes: the frontends' parser."""


def caller_outside_launch(made: object) -> Place | None:
    """The place in the innermost running code that is neither ours nor the constructor of `made` itself."""
    frame: FrameType | None = sys._getframe(2)
    while frame is not None:
        code = frame.f_code
        if code in MAKERS:
            return None
        if not code.co_filename.startswith(FACES) and not (
            code.co_name == '__init__' and _makes(code, frame, made)
        ):
            return code, frame.f_lasti
        frame = frame.f_back
    return None


def _makes(code: CodeType, frame: FrameType, made: object) -> bool:
    """Whether the frame is the constructor, in a student's subclass, of the very object."""
    return bool(code.co_argcount) and frame.f_locals.get(code.co_varnames[0]) is made


def origin_of(place: Place | None) -> Origin | None:
    """The engine's `Origin` for a place."""
    if place is None:
        return None
    from edulaunch.processes import Origin
    where, position = place
    return Origin(where, position) if isinstance(where, str) else Origin(where.co_filename, _line_at(where, position))


def _line_at(code: CodeType, position: int) -> int:
    from bisect import bisect_right
    starts, lines = _line_table(code)
    return lines[bisect_right(starts, position) - 1]


@lru_cache(maxsize=64)
def _line_table(code: CodeType) -> tuple[list[int], list[int]]:
    rows = [(start, line) for start, _, line in code.co_lines() if line is not None]
    return [start for start, _ in rows], [line for _, line in rows]


def note_origin(error: BaseException, entity: Any) -> None:
    """Remember on `error` (as `edulaunch_origin` and `edulaunch_entity`) which action raised it; the
    innermost stays.
    """
    if not hasattr(error, 'edulaunch_origin'):
        error.edulaunch_origin = entity.origin  # type: ignore[attr-defined]
        error.edulaunch_entity = type(entity).__name__  # type: ignore[attr-defined]
