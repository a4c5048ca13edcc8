"""Determines the owner of a file (the engine, Python and its installed packages, or the student), and a program's current line in
the student's code.
"""

from __future__ import annotations

import os
import re
import site
import sys
import sysconfig
from types import FrameType
from typing import Any

from edulaunch.engine.sim.task import Task
from edulaunch.engine.underlay_place import engine_folder

ENGINE = engine_folder() + os.sep
_KEPT = ('stdlib', 'platstdlib', 'purelib', 'platlib')
LIBRARIES = tuple(
    dict.fromkeys(
        os.path.join(folder, '')
        for folder in (os.path.dirname(os.__file__), *map(sysconfig.get_path, _KEPT), site.getusersitepackages())
        if folder  # a browser has no user folder
    )
)
"""Python's own folders. A workspace that was built has a `site-packages`, too, which is not among them."""


def is_engine(filename: str) -> bool:
    """Return whether a path is a file of edulaunch, or the name of code that does not come from a file."""
    return filename.startswith((ENGINE, '<frozen', '<interface '))


def is_library(filename: str) -> bool:
    """Return whether a file belongs to Python or to an installed package, which students do not write."""
    return filename.startswith(LIBRARIES) and not is_engine(filename)


def is_own(filename: str) -> bool:
    """Return whether the student wrote a file."""
    return not filename.startswith(('<frozen', '<interface ', ENGINE, *LIBRARIES))


def student_line(frame: FrameType | None = None) -> dict[str, Any]:
    """Return the innermost line of the student's code among a frame and its callers, for a fact.

    The result contains `file`, `line` and `function`. If this line calls other code, `calls` names that code, such as
    'timer.sleep' (file and function). A view has the name of the module that it replaces. Without code of a student, the
    result is empty.

    :param frame: the frame to start from (default: the frame of the caller).
    """
    inner: FrameType | None = None
    here = frame if frame is not None else sys._getframe(1)
    at: FrameType | None = here
    while at is not None and not is_own(at.f_code.co_filename):
        inner, at = at, at.f_back
    if at is None:
        return {}
    line: dict[str, Any] = {'file': at.f_code.co_filename, 'line': at.f_lineno, 'function': at.f_code.co_name}
    if inner is not None:
        stem = os.path.splitext(os.path.basename(inner.f_code.co_filename))[0]
        line['calls'] = f'{re.sub("_views?$", "", stem)}.{inner.f_code.co_name}'
    return line


def waiting_line(task: Task) -> dict[str, Any]:
    """Return the :func:`student_line` of a parked task."""
    return {} if task.frame is None else student_line(task.frame)


def coroutine_line(coroutine: Any) -> dict[str, Any]:
    """Return the place where a coroutine waits, in the form of :func:`student_line`."""
    line: dict[str, Any] = {}
    while (frame := getattr(coroutine, 'cr_frame', None)) is not None:
        if is_own(frame.f_code.co_filename):
            line = {'file': frame.f_code.co_filename, 'line': frame.f_lineno, 'function': frame.f_code.co_name}
        coroutine = coroutine.cr_await
    return line
