"""A traceback cut to what the student wrote."""
from __future__ import annotations

import os
import traceback
from types import TracebackType

from edulaunch.processes.origin import Origin

_ENGINE = os.path.dirname(os.path.dirname(os.path.abspath(__file__))) + os.sep


def student_traceback(error: BaseException) -> tuple[str, Origin | None]:
    """The text that Python would print, without frames of the engine, and the last place in a file that is not ours.

    When no other frame is left, all frames stay: then the mistake is in our own code and hiding it would help nobody.
    The marks under a line that newer Pythons print are left out, so that recordings are equal on all of them.
    """
    frames = traceback.extract_tb(error.__traceback__)
    own = [frame for frame in frames if not _is_engine(frame.filename)]
    lines = ['Traceback (most recent call last):\n'] if frames else []
    for frame in own or frames:
        lines.append(f'  File "{frame.filename}", line {frame.lineno}, in {frame.name}\n')
        if frame.line:
            lines.append(f'    {frame.line}\n')
    lines += traceback.format_exception_only(type(error), error)
    last = own[-1] if own else None
    return ''.join(lines), Origin(last.filename, last.lineno or 0) if last else None


def innermost_place(trace: TracebackType | None) -> Origin | None:
    """The last frame of a traceback that is not in the engine."""
    own = [frame for frame in traceback.extract_tb(trace) if not _is_engine(frame.filename)]
    return Origin(own[-1].filename, own[-1].lineno or 0) if own else None


def _is_engine(filename: str) -> bool:
    return filename.startswith((_ENGINE, '<frozen'))
