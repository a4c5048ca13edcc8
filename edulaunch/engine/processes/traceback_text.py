"""Reduces a traceback to the student's code. The last line ends with `Did you mean: 'x'?`, as in Python 3.12 of ROS 2 Jazzy.

The result is the same with every version of Python.
"""

from __future__ import annotations

import re
import sys
import textwrap
import traceback
from collections.abc import Callable, Iterator
from types import FrameType, TracebackType
from typing import Any

from edulaunch.engine.facts import facts_of
from edulaunch.engine.processes.frame_owner import is_engine, is_library
from edulaunch.engine.processes.spec import Origin
from edulaunch.engine.processes.watchdog import BlockedProgram

MOST_NAMES, LONGEST_NAME = 750, 40
STEP, CASE = 2, 1
"""The cost of adding, dropping or replacing a letter, and of changing only its case."""
_SAID = re.compile(r"\. Did you (mean: '[^']*'\?( Or did you forget to import '[^']*'\??)?|forget to import '[^']*'\??)$")
_NOT_IN_MODULE = re.compile(r"cannot import name '(\w+)' from '([\w.]+)' ")


def with_suggestion(text: str, error: BaseException) -> str:
    """Return the last line of a traceback with Python 3.12's suggestion.

    A message of several lines does not change, because it contains its own help.
    """
    line = text.rstrip('\n')
    if '\n' in line or not isinstance(error, (AttributeError, ImportError, NameError)):
        return text
    return f'{_SAID.sub("", line)}{_suggestion(error)}\n'


def _suggestion(error: BaseException) -> str:
    name: str | None = getattr(error, 'name', None)
    if isinstance(error, ImportError):
        found = _NOT_IN_MODULE.match(str(error))
        module = sys.modules.get(found[2]) if found else None
        near = _nearest(found[1], dir(module)) if found and module is not None else None
    elif isinstance(error, NameError):
        near = _name_in_reach(error)
    else:
        near = _nearest(name, _names_of(error)) if name else None
    suggestion = f". Did you mean: '{near}'?" if near else ''
    if isinstance(error, NameError) and name in sys.stdlib_module_names:
        return f"{suggestion} Or did you forget to import '{name}'?" if suggestion else f". Did you forget to import '{name}'?"
    return suggestion


def _names_of(error: Any) -> list[str]:
    try:
        return dir(error.obj)
    except Exception:  # a student's __dir__ may raise any exception
        return []


def _name_in_reach(error: NameError) -> str | None:
    """Return the attribute of `self` that has exactly this name, or else the nearest variable at the place of the error, or
    None.
    """
    trace = error.__traceback__
    if trace is None or not error.name:
        return None
    while trace.tb_next is not None:
        trace = trace.tb_next
    frame: FrameType = trace.tb_frame
    if error.name in _attributes(frame.f_locals.get('self')):
        return f'self.{error.name}'
    return _nearest(error.name, [*frame.f_locals, *frame.f_globals, *frame.f_builtins])


def _attributes(student: Any) -> set[str]:
    return {*getattr(student, '__dict__', ()), *dir(type(student))} if student is not None else set()


def _nearest(wrong: str, names: list[str]) -> str | None:
    """Return the name that needs the fewest changes, or None if it needs too many: more than a third of the letters of both
    names.
    """
    if len(names) > MOST_NAMES or len(wrong) > LONGEST_NAME:
        return None
    best, least = None, len(wrong)
    for name in names:
        limit = min((len(name) + len(wrong) + 3) * STEP // 6, least - 1)
        if name != wrong and abs(len(name) - len(wrong)) * STEP <= limit:
            cost = _changes(wrong, name)
            if cost <= limit:
                best, least = name, cost
    return best


def _changes(one: str, other: str) -> int:
    """Return the cost of turning one word into the other word."""
    row = list(range(0, STEP * len(other) + 1, STEP))
    for letter in one:
        diagonal, row[0] = row[0], row[0] + STEP
        for position, wanted in enumerate(other, 1):
            exchange = 0 if letter == wanted else CASE if letter.lower() == wanted.lower() else STEP
            cost = min(diagonal + exchange, row[position] + STEP, row[position - 1] + STEP)
            diagonal, row[position] = row[position], cost
    return row[-1]


MOST = 15
"""The number of shown members, which is Python's default."""


def members_of(error: BaseException) -> tuple[BaseException, ...]:
    """Return the members of an exception group (Python 3.11 and later), or () for any other error."""
    members = getattr(error, 'exceptions', ())
    is_group = isinstance(members, tuple) and hasattr(error, 'derive') and hasattr(error, 'split')
    return members if is_group else ()


def within(text: str, depth: int, corner: str = '|') -> str:
    """Return a string inside `depth` frames. The first line begins with `corner`, which starts a new frame."""
    if not depth:
        return text
    indent = '  ' * depth
    first, _, rest = text.partition('\n')
    return f'{indent}{corner} {first}\n' + textwrap.indent(rest, f'{indent}| ', lambda line: True)


def framed(members: tuple[BaseException, ...], depth: int, tell: Callable[[BaseException, int], Iterator[str]]) -> Iterator[str]:
    """Yield the lines of the members of a group, each member in its own frame.

    :param members: the members of the group.
    :param depth: the number of frames around the members, including the frame of their group.
    :param tell: a function that yields the message of one member inside the given number of frames.
    """
    indent = '  ' * depth
    shown = members[:MOST]
    closed = False
    for number, member in enumerate(shown, start=1):
        yield f'{indent}{"+-" if number == 1 else "  "}+---------------- {number} ----------------\n'
        yield from tell(member, depth + 1)
        closed = bool(members_of(member))
    if len(members) > MOST:
        more = len(members) - MOST
        yield f'{indent}  +---------------- ... ----------------\n'
        yield within(f'and {more} more exception{"s" if more > 1 else ""}\n', depth + 1)
        closed = False
    if not closed:  # the last frame of a group also closes the outer group
        yield f'{indent}  +------------------------------------\n'


CAUSE = '\nThe above exception was the direct cause of the following exception:\n\n'
CONTEXT = '\nDuring handling of the above exception, another exception occurred:\n\n'


def student_traceback(error: BaseException) -> tuple[str, Origin | None]:
    """Return Python's traceback without frames of the engine, and the last place in a student's file (None if there is no such
    place).

    If all frames belong to the engine, they all stay, because the mistake is then in edulaunch. Errors that edulaunch
    raises deliberately never show frames of the engine: an error with facts, an error of rclpy, and Ctrl-C. The same
    applies to a file that Python could not parse, because none of its code ran. It also applies to a file that a built-in
    program could not open, because its path came from the student. Newer versions of Python print marks under a line. These
    are left out, so that recordings are equal with all versions.
    """
    return ''.join(_chain(error, [])), _place(error)


def _place(error: BaseException) -> Origin | None:
    members = members_of(error)
    if members:
        return _place(members[0]) or innermost_place(error.__traceback__)
    unread = _unread_file(error)
    return Origin(unread, getattr(error, 'lineno', 0) or 0) if unread is not None else innermost_place(error.__traceback__)


def _chain(error: BaseException, reported: list[BaseException], depth: int = 0) -> Iterator[str]:
    """Yield the lines of an error, after the lines of its cause or of the error that was being handled.

    An error that was being handled is included only if it occurred in the student's code.

    :param reported: the errors that are included already.
    :param depth: the number of frames of exception groups around the error.
    """
    reported.append(error)
    cause, context = error.__cause__, error.__context__
    if cause is not None and cause not in reported:
        yield from _chain(cause, reported, depth)
        yield within(CAUSE, depth)
    elif context is not None and cause is None and not error.__suppress_context__ and context not in reported and _own(context):
        yield from _chain(context, reported, depth)
        yield within(CONTEXT, depth)
    members, text = members_of(error), ''.join(_one(error))
    if not members:
        yield within(text, depth)
        return
    if text.startswith('Traceback'):
        yield within(f'Exception Group {text}', depth or 1, '|' if depth else '+')
    else:
        yield within(text, depth or 1)
    yield from framed(members, depth or 1, lambda member, deeper: _chain(member, reported, deeper))


def _one(error: BaseException) -> Iterator[str]:
    """Yield the lines of one error, without the errors that caused it."""
    own = _own(error)
    knowingly = bool(facts_of(error)) or isinstance(error, KeyboardInterrupt) or type(error).__module__.startswith('rclpy.')
    explained = knowingly or _unread_file(error) is not None or _names_a_file(error)
    shown = traceback.extract_tb(error.__traceback__) if not own and not explained else own
    if shown:
        yield 'Traceback (most recent call last):\n'
    plain = [traceback.FrameSummary(frame.filename, frame.lineno, frame.name, line=frame.line) for frame in shown]
    yield from traceback.StackSummary.from_list(plain).format()
    *before, last = _lines_of_python(error)
    yield from (*before, with_suggestion(last, error))


def _lines_of_python(error: BaseException) -> list[str]:
    """Return the lines with the type and the message of an error. For a group, leave out the members, which newer versions
    list here.
    """
    members = members_of(error)
    reported = traceback.format_exception_only(type(error), error)
    return reported if not members else [next(line for line in reported if line.strip())]


def _own(error: BaseException) -> list[traceback.FrameSummary]:
    """Return the frames of an error that are outside the engine."""
    return [frame for frame in traceback.extract_tb(error.__traceback__) if not is_engine(frame.filename)]


def _unread_file(error: BaseException) -> str | None:
    """Return the student's file that Python could not parse, or None for another error."""
    unread = error.filename if isinstance(error, SyntaxError) else None
    return None if unread is None or is_engine(unread) else unread


def _names_a_file(error: BaseException) -> bool:
    return isinstance(error, OSError) and error.filename is not None


def runaway_text(program: str, error: BaseException) -> tuple[str, Origin | None]:
    """Return the message about a program that was stopped because it did not yield, and the place of the stop.

    An unknown place gives None as the second value.

    :param program: the launch name of the program.
    :param error: the exception that stopped the program.
    """
    text, place = student_traceback(error)
    frames = ''.join(f'{line}\n' for line in text.splitlines() if line.startswith((' ', 'Traceback')))
    where = f' at {place}' if place is not None else ''
    did = str(error) if isinstance(error, BlockedProgram) else f'{error} without waiting for anything'
    return f'{frames}RunawayProgramError: {program} {did}; it was stopped{where}.\n', place


def innermost_place(trace: TracebackType | None) -> Origin | None:
    """Return the place of the last frame in a student's file. Without such a frame, return the place of the last frame outside
    the engine. Return None if all frames belong to the engine.
    """
    own = [frame for frame in traceback.extract_tb(trace) if not is_engine(frame.filename)]
    last = next((frame for frame in reversed(own) if not is_library(frame.filename)), own[-1] if own else None)
    return None if last is None else Origin(last.filename, last.lineno or 0)
