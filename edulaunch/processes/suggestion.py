"""`Did you mean: 'x'?` at the end of an error, as Python 3.12, that of ROS 2 Jazzy, says it; the same on every Python."""

from __future__ import annotations

import re
import sys
from types import FrameType
from typing import Any

MOST_NAMES, LONGEST_NAME = 750, 40
STEP, CASE = 2, 1
"""What it costs to add, drop or exchange a letter, and to change only its case."""
_SAID = re.compile(r"\. Did you (mean: '[^']*'\?( Or did you forget to import '[^']*'\??)?|forget to import '[^']*'\??)$")
_NOT_IN_MODULE = re.compile(r"cannot import name '(\w+)' from '([\w.]+)' ")


def with_suggestion(text: str, error: BaseException) -> str:
    """The last line of a traceback, with the suggestion that belongs to it. Texts of several lines have help of their own."""
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
    said = f". Did you mean: '{near}'?" if near else ''
    if isinstance(error, NameError) and name in sys.stdlib_module_names:
        return f"{said} Or did you forget to import '{name}'?" if said else f". Did you forget to import '{name}'?"
    return said


def _names_of(error: Any) -> list[str]:
    try:
        return dir(error.obj)
    except Exception:  # a student's __dir__ may do anything
        return []


def _name_in_reach(error: NameError) -> str | None:
    """The nearest variable where the error arose, or the attribute of `self` that has the very name."""
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
    """The name with the least changes, if these are few: at most a third of the letters of both."""
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
    """What it costs to make one word of the other."""
    row = list(range(0, STEP * len(other) + 1, STEP))
    for letter in one:
        diagonal, row[0] = row[0], row[0] + STEP
        for position, wanted in enumerate(other, 1):
            exchange = 0 if letter == wanted else CASE if letter.lower() == wanted.lower() else STEP
            cost = min(diagonal + exchange, row[position] + STEP, row[position - 1] + STEP)
            diagonal, row[position] = row[position], cost
    return row[-1]
