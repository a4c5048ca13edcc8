"""Which line of which launch file made an action.

ROS 2 does not know this; errors, `edulaunch doctor` and grades point there. It must cost next to nothing,
because every action pays for it: two numbers are kept, and made readable only when somebody asks.
"""
from __future__ import annotations

import os
import sys
from types import CodeType, FrameType
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from edulaunch.processes import Origin

FACES = os.path.dirname(os.path.dirname(os.path.abspath(__file__))) + os.sep
Place = tuple[str, int]


def caller_outside_launch(made: object) -> Place | None:
    """File and line of the innermost running code that is neither ours nor the constructor of `made` itself.
    """
    frame: FrameType | None = sys._getframe(2)
    while frame is not None:
        code = frame.f_code
        if not code.co_filename.startswith(FACES) and not (
            code.co_name == '__init__' and _makes(code, frame, made)
        ):
            return code.co_filename, frame.f_lineno
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
    return Origin(*place)


def note_origin(error: BaseException, entity: Any) -> None:
    """Remember on `error` (as `edulaunch_origin` and `edulaunch_entity`) which action raised it; the
    innermost stays.
    """
    if not hasattr(error, 'edulaunch_origin'):
        error.edulaunch_origin = entity.origin  # type: ignore[attr-defined]
        error.edulaunch_entity = type(entity).__name__  # type: ignore[attr-defined]
