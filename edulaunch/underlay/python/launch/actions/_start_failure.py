"""What to say of a program that could not be started."""

from __future__ import annotations

import os
from traceback import format_exception_only
from typing import TYPE_CHECKING, Any

from .._engine import running_process

if TYPE_CHECKING:
    from .execute_local import ExecuteLocal


def start_failure(error: Exception, action: ExecuteLocal, details: dict[str, Any]) -> str:
    """Python's own last line about `error`, and a line of help with the place of the action.

    ROS 2 shows a traceback of launch instead, in which nothing is the student's.
    """
    said = ''.join(format_exception_only(error)).rstrip()
    origin = action.origin
    place = '' if origin is None else f'{running_process().index.source_path(origin.file)}:{origin.line}: '
    advice = _advice(error, details)
    return f'{said}\n  help: {place}{advice}' if place or advice else said


def _advice(error: Exception, details: dict[str, Any]) -> str:
    program, folder = details['cmd'][0], details['cwd']
    if folder and not os.path.isdir(folder):
        return f'cwd={folder!r} is no folder'
    if isinstance(error, FileNotFoundError):
        if len(details['cmd']) > 1 and all(len(word) == 1 for word in details['cmd']):
            return 'cmd is one text, of which each letter became a word: put it into a list, cmd=[[...]] with shell=True'
        blank = '; write each argument as an item of cmd of its own, or shell=True' if ' ' in program else ''
        where = 'there is no such file' if os.sep in program else f'there is no program {program!r} on the PATH'
        return where + blank
    if isinstance(error, PermissionError):
        return f'{program!r} is not executable: chmod +x it'
    return 'this program could not be started'
