"""Where in the student's code something happens."""

from __future__ import annotations

import os
import sys
from typing import Any

from edulaunch.underlay_place import engine_folder

ENGINE = engine_folder() + os.sep


def student_place() -> str:
    """Where the running call stands: ` (file.py:12)`, or '' when no student's code is on the way."""
    frame: Any = sys._getframe()
    while frame is not None and is_engine(frame.f_code.co_filename):
        frame = frame.f_back
    return '' if frame is None else f' ({os.path.basename(frame.f_code.co_filename)}:{frame.f_lineno})'


def student_level() -> int:
    """The `stacklevel` with which a warning by the caller of this names the student's line; 2 when there is none on the way."""
    level, frame = 1, sys._getframe(1)
    while is_engine(frame.f_code.co_filename):
        if frame.f_back is None:
            return 2
        level, frame = level + 1, frame.f_back
    return level


def coroutine_place(coroutine: Any) -> str:
    """Where a coroutine waits, in the same form."""
    place = ''
    while getattr(coroutine, 'cr_frame', None) is not None:
        file = coroutine.cr_frame.f_code.co_filename
        if not is_engine(file):
            place = f' ({os.path.basename(file)}:{coroutine.cr_frame.f_lineno})'
        coroutine = coroutine.cr_await
    return place


def is_engine(file: str) -> bool:
    """Whether a file is one of ours, or made by us."""
    return file.startswith((ENGINE, '<'))
