"""One line of help for errors of launch files, which ROS 2 lacks.

The errors themselves keep ROS's and Python's own texts. Here is added where in whose file it happened, and
what was probably meant.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Iterator
from types import FrameType
from typing import TYPE_CHECKING, Any

from ._engine import running_process
from .invalid_launch_file_error import InvalidLaunchFileError

if TYPE_CHECKING:
    from edulaunch.processes import Origin

_OURS = os.path.dirname(os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))) + os.sep
_PYTHON = os.path.dirname(os.path.abspath(os.__file__)) + os.sep


def show_help(error: BaseException) -> None:
    """Write the line about `error` below its message, and keep the error for whoever runs this process.

    The launch process's `state['launch.exceptions']` collects them; `state['launch.show_help']` can replace
    the writing.
    """
    process = running_process()
    process.state.setdefault('launch.exceptions', []).append(error)
    show = process.state.get('launch.show_help')
    if show is not None:
        show(error)
        return
    line = help_line(error)
    if line is not None:
        process.stdout.write(line + '\n')


def help_line(error: BaseException) -> str | None:
    """`  help: file.launch.py:12 (Node): what to try`; None when nothing is known."""
    text = launch_help(error)
    place = launch_origin(error)
    start = '' if place is None else f'{place._replace(file=running_process().index.source_path(place.file))}{_entity(error)}'
    if not (text or start):
        return None
    return f'  help: {": ".join(part for part in (start, text) if part)}'


def launch_help(error: BaseException) -> str | None:
    """What to try after `error`, which was raised while a launch file was loaded or visited; one line, or
    None.
    """
    from . import _help_rules

    cause = root_cause(error)
    for rule in _help_rules.RULES:
        if isinstance(cause, rule.error_type):
            text = rule.advise(cause, str(cause))
            if text is not None:
                return text
    hint: str | None = getattr(cause, 'edulaunch_hint', None)
    return hint


def launch_origin(error: BaseException) -> Origin | None:
    """Where in a student's file it happened: the innermost line that was running there, else the line of the
    action.
    """
    from edulaunch.processes import Origin

    cause = root_cause(error)
    if isinstance(cause, SyntaxError) and cause.filename and not cause.filename.startswith('<'):
        return Origin(cause.filename, cause.lineno or 1)
    line = getattr(cause, 'edulaunch_line', None)
    if line is not None and getattr(cause, 'edulaunch_file', None):
        return Origin(cause.edulaunch_file, line)  # type: ignore[attr-defined]
    for frame, number in reversed(list(frames_of(cause))):
        if is_students(frame.f_code.co_filename):
            return Origin(frame.f_code.co_filename, number)
    origin: Origin | None = getattr(cause, 'edulaunch_origin', None) or getattr(error, 'edulaunch_origin', None)
    return origin if origin is not None and is_students(origin.file) else None


def root_cause(error: BaseException) -> BaseException:
    """What the loader that was tried first said, when none could load the file; else the error itself."""
    while isinstance(error, InvalidLaunchFileError) and error._likely_errors:
        error = error._likely_errors[0]
    return error


def frames_of(error: BaseException) -> Iterator[tuple[FrameType, int]]:
    """The frames of the traceback, outermost first, with the line that ran in each."""
    trace = error.__traceback__
    while trace is not None:
        yield trace.tb_frame, trace.tb_lineno
        trace = trace.tb_next


def local_of(error: BaseException, name: str) -> Any:
    """The value that the variable of this name had in the innermost frame that has one; None when there is
    none.
    """
    found = None
    for frame, _ in frames_of(error):
        if name in frame.f_code.co_varnames:
            found = frame.f_locals.get(name, found)
    return found


def is_students(filename: str) -> bool:
    """Whether a file is neither ours nor Python's nor that of an installed package."""
    if filename.startswith(('<', _PYTHON)) or 'site-packages' in filename or filename.endswith('.pyx'):
        return False
    shared = os.path.join(_OURS, 'underlay', 'share') + os.sep
    return filename.startswith(shared) or not filename.startswith(_OURS)


def _entity(error: BaseException) -> str:
    name = getattr(error, 'edulaunch_entity', None)
    return f' ({name})' if name else ''


def loaded(module: str) -> Any:
    """A module of ours if it can be imported, else None."""
    try:
        __import__(module)
    except ImportError:
        return None
    return sys.modules[module]
