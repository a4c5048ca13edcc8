"""An error of a launch file as plain data: its place in the student's file, and facts that its message does not contain.

The errors keep the messages of ROS and Python. `edulaunch.advice` adds advice to the messages.
"""

from __future__ import annotations

import linecache
import os
import re
from collections.abc import Iterator
from types import FrameType
from typing import TYPE_CHECKING, Any

from edulaunch.engine.facts import facts_of
from edulaunch.engine.nearest import nearest_file
from edulaunch.engine.underlay_place import is_students

from ._engine import running_process
from .invalid_launch_file_error import InvalidLaunchFileError

if TYPE_CHECKING:
    from edulaunch.engine.packages import Index
    from edulaunch.engine.processes import Origin

CALL_LINES = 8
"""The longest call, in lines, that is searched for the names of its arguments."""


def note_failure(error: BaseException, message: str) -> None:
    """Record that an error ended the launch, so that readers of `message` also see advice.

    `state['launch.exceptions']` of the launch process collects these errors. A function in `state['launch.on_error']` can replace
    this report.
    """
    process = running_process()
    process.state.setdefault('launch.exceptions', []).append(error)
    take = process.state.get('launch.on_error')
    if take is not None:
        take(error)
    else:
        process.host.hints.expect(message, {**failure_data(error), 'process': None}, process.group.pid)


def failure_data(error: BaseException, index: Index | None = None) -> dict[str, Any]:
    """Return `type`, `message`, `place` (in the student's own file) and `facts` of an error.

    :param index: the index that finds the student's own files. By default, this is the index of the running process.
    """
    cause, place = root_cause(error), launch_origin(error)
    if place is not None:
        place = place._replace(file=(index or running_process().index).source_path(place.file))
    return {'type': type(cause).__name__, 'message': str(cause), 'place': place, 'facts': launch_facts(error)}


def launch_facts(error: BaseException) -> dict[str, Any]:
    """Return the facts attached to the error, or else the facts found in the frames of its traceback.

    The result also contains the name of the action's class that raised the error, if it is known.
    """
    cause = root_cause(error)
    action = getattr(error, 'edulaunch_entity', None)
    known = facts_of(cause)
    if not known:  # store the facts now: after the run, the packages of this process are unknown
        known = cause.edulaunch_facts = _found_in_frames(cause)  # type: ignore[attr-defined]
    return {**known, **({'action': action} if action else {})}


def launch_origin(error: BaseException) -> Origin | None:
    """Return the place in a student's file: the innermost line that was running there, or the line of the action.

    Return None if the error has no place in a student's file.
    """
    from edulaunch.engine.processes import Origin

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
    """Return the error of the first loader if no loader could load the file. Otherwise, return the error itself."""
    while isinstance(error, InvalidLaunchFileError) and error.likely_errors:
        error = error.likely_errors[0]
    return error


def frames_of(error: BaseException) -> Iterator[tuple[FrameType, int]]:
    """Yield each frame of the traceback, outermost first, with the line that was running in the frame."""
    trace = error.__traceback__
    while trace is not None:
        yield trace.tb_frame, trace.tb_lineno
        trace = trace.tb_next


def _found_in_frames(error: BaseException) -> dict[str, Any]:
    text = str(error)
    if isinstance(error, ModuleNotFoundError):
        return _file_beside(error)
    if isinstance(error, FileNotFoundError) and isinstance(error.filename, str):
        return _about_file(error.filename)
    if isinstance(error, TypeError):
        if 'got an unexpected keyword' in text:
            return _class_that_was_made(error)
        if 'required' in text:
            return {'given_names': _names_in_call(error, text)}
    if isinstance(error, (TypeError, ValueError)) and 'unpack' in text:
        is_include = type(_local_of(error, 'self')).__name__ == 'IncludeLaunchDescription'
        return {'about': 'launch.no-pairs'} if is_include else {}
    return _not_a_text(error, text) if isinstance(error, TypeError) else {}


def _file_beside(error: ModuleNotFoundError) -> dict[str, Any]:
    place = launch_origin(error)
    file = f'{error.name}.py'
    return {'file_beside': file} if place and os.path.isfile(os.path.join(os.path.dirname(place[0]), file)) else {}


def _about_file(path: str) -> dict[str, Any]:
    from edulaunch.ros.sources.missing import installed_file

    from ._absent_packages import absent_file

    known = installed_file(running_process().index, path) or absent_file(path)
    if known:
        return known
    folder = os.path.dirname(path) or '.'
    if not os.path.isdir(folder):
        return {'wanted': path, 'no_folder': folder}
    name, ending = os.path.basename(path), os.path.splitext(path)[1]
    beside = os.listdir(folder)
    longer = next((f'{name}{end}' for end in ('.py', '.xml', '.yaml') if f'{name}{end}' in beside), None)
    near = longer or nearest_file(name, [other for other in beside if other.endswith(ending)])
    if near is None and '.launch.' in name:  # a launch file of the same name in another format
        stem = name.removesuffix(ending)
        near = next((f'{stem}{end}' for end in ('.py', '.xml', '.yaml') if f'{stem}{end}' in beside), None)
    return {'wanted': path, 'near': near, 'below': None if near else _below(folder, name)}


def _below(folder: str, name: str) -> str | None:
    """Return the path of the only file of that name below a folder of a package's share folder, or None.

    The path is relative to the folder.
    """
    if not os.path.isfile(os.path.join(folder, 'package.xml')):
        return None
    inside = [one for one in sorted(os.listdir(folder)) if os.path.isfile(os.path.join(folder, one, name))]
    return f'{inside[0]}/{name}' if len(inside) == 1 else None


def _class_that_was_made(error: BaseException) -> dict[str, Any]:
    """Return the class whose constructor passes on an unknown argument, and the arguments that the class accepts."""
    made = next((frame.f_locals.get('self') for frame, _ in frames_of(error) if frame.f_code.co_name == '__init__'), None)
    if made is None:
        return {}
    found: list[str] = []
    for base in type(made).__mro__:
        code = getattr(base.__dict__.get('__init__'), '__code__', None)
        if code is not None:
            found += [name for name in code.co_varnames[1 : code.co_argcount + code.co_kwonlyargcount] if name not in found]
            if not code.co_flags & 0x08:  # without **kwargs it passes no arguments on
                break
    return {'class': type(made).__name__, 'keywords': found}


def _names_in_call(error: BaseException, text: str) -> list[str]:
    """Return the names of the arguments in the call of a class that reports a missing argument."""
    match, place = re.match(r'(\w+)\.', text), launch_origin(error)
    if match is None or place is None:
        return []
    lines = ''.join(linecache.getline(place.file, line) for line in range(place.line, place.line + CALL_LINES))
    calls = re.split(rf'\b{match[1]}\(', lines, flags=re.IGNORECASE)  # the class PushROSNamespace has another spelling, too
    return re.findall(r'(\w+)\s*=', calls[1]) if len(calls) > 1 else []


def _not_a_text(error: BaseException, text: str) -> dict[str, Any]:
    """Return the facts for a number, boolean or path where strings and substitutions are expected."""
    if re.match(r"'(int|float|bool|PosixPath|WindowsPath)' object is not iterable", text):
        value = _local_of(error, 'subs')
    elif text.startswith('Failed to normalize given item of type'):
        value = _local_of(error, 'item')
    else:
        return {}
    number = isinstance(value, (int, float))
    is_joined = any(frame.f_code.co_filename.endswith('path_join_substitution.py') for frame, _ in frames_of(error))
    return {
        'about': 'launch.not-a-text',
        'keyword': None if isinstance(value, (list, tuple)) else _keyword_with(error, value),
        'value': repr(value) if number else None,
        'as_text': str(value).lower() if number else None,
        'as_path': 'str(...)' if isinstance(value, os.PathLike) else None,
        'joiner': 'PathJoinSubstitution' if is_joined and isinstance(value, (list, tuple)) else None,
        'nested': repr(value)[:40] if isinstance(value, (list, tuple)) else None,
        'given': type(value).__name__,
    }


def _local_of(error: BaseException, name: str) -> Any:
    """Return the value of the local variable `name` in the innermost frame that has such a variable, or None."""
    values = [frame.f_locals.get(name) for frame, _ in frames_of(error) if name in frame.f_code.co_varnames]
    return values[-1] if values else None


def _keyword_with(error: BaseException, value: object) -> str | None:
    for frame, _ in reversed(list(frames_of(error))):
        if frame.f_code.co_name == '__init__':
            for name, known in frame.f_locals.items():
                if known is value:
                    return name
    return None
