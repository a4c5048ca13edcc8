"""A traceback cut to what the student wrote."""
from __future__ import annotations

import os
import traceback
from types import TracebackType
from typing import TYPE_CHECKING

from edulaunch.errors import RunawayProgramError
from edulaunch.processes.origin import Origin

if TYPE_CHECKING:
    from edulaunch.processes.process import Process

_ENGINE = os.path.dirname(os.path.dirname(os.path.abspath(__file__))) + os.sep


def student_traceback(error: BaseException) -> tuple[str, Origin | None]:
    """The text that Python would print, without frames of the engine, and the last place in a file that is not ours.

    When no other frame is left, all frames stay: then the mistake is in our own code and hiding it would help nobody. Unless the
    error carries a hint: then we have raised it knowingly. Or Python could not read the student's file at all: then nothing of it ran.
    The marks under a line that newer Pythons print are left out, so that recordings are equal on all of them.
    """
    frames = traceback.extract_tb(error.__traceback__)
    own = [frame for frame in frames if not _is_engine(frame.filename)]
    unread = error.filename if isinstance(error, SyntaxError) else None
    explained = hasattr(error, 'edulaunch_hint') or (unread is not None and not _is_engine(unread))
    shown = frames if not own and not explained else own
    lines = ['Traceback (most recent call last):\n'] if shown else []
    for frame in shown:
        lines.append(f'  File "{frame.filename}", line {frame.lineno}, in {frame.name}\n')
        if frame.line:
            lines.append(f'    {frame.line}\n')
    lines += traceback.format_exception_only(type(error), error)
    if isinstance(error, SyntaxError) and unread is not None and explained:
        return ''.join(lines), Origin(unread, error.lineno or 0)
    last = own[-1] if own else None
    return ''.join(lines), Origin(last.filename, last.lineno or 0) if last else None


def runaway_text(process: Process, error: BaseException) -> tuple[str, Origin | None]:
    """What to say of a program that was stopped because it kept its turn, and where it was."""
    text, place = student_traceback(error)
    frames = ''.join(f'{line}\n' for line in text.splitlines() if line.startswith((' ', 'Traceback')))
    seconds = process.host.watchdog.seconds if process.host.watchdog is not None else 0
    where = f' at {place}' if place is not None else ''
    told = RunawayProgramError(
        f'{process.name} kept its turn for {seconds:g} s of real time without waiting for anything; it was stopped{where}.',
        help='a loop must wait: time.sleep(), rclpy.spin_once(), rate.sleep() or a timer give the others their turn')
    return f'{frames}RunawayProgramError: {told}\n', place


def innermost_place(trace: TracebackType | None) -> Origin | None:
    """The last frame of a traceback that is not in the engine."""
    own = [frame for frame in traceback.extract_tb(trace) if not _is_engine(frame.filename)]
    return Origin(own[-1].filename, own[-1].lineno or 0) if own else None


def _is_engine(filename: str) -> bool:
    return filename.startswith((_ENGINE, '<frozen'))
