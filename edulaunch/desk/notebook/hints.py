"""Help in a notebook: completion of `%ros2` with Tab, and a line of help below a NameError or a missing folder.

Such an error nearly always means that a cell was not run.
"""

from __future__ import annotations

import linecache
import os
import re
from collections.abc import Iterable
from types import TracebackType
from typing import TYPE_CHECKING, Any

from edulaunch.desk.cli.candidates import ros2_words
from edulaunch.desk.view import TABS
from edulaunch.desk.view.panes import completions
from edulaunch.engine.nearest import nearest
from edulaunch.runtime.session import index_for

if TYPE_CHECKING:
    from edulaunch.desk.notebook.terminal import CellTerminal

_LINE = re.compile(r'(?:^|.*=)\s*%{1,2}ros2\s+(.*)$')
OWN_WORDS = ('view', 'jobs', 'stop', 'wait')
OWN_OPTIONS = ('--for', '--seed', '--quiet')
SET_UP = ('Path', 'edulaunch', 'compare', 'predict', 'quiz')
"""Names that the first cells of lessons import."""


def unfinished(text: str, line: str) -> str | None:
    """Return the words after `ros2` on an unfinished line of a cell, or None for a line of Python.

    :param text: the content of the cell up to the cursor.
    :param line: the last line of `text`.
    """
    if text.startswith('%%ros2') and '\n' in text:
        return line.lstrip()
    found = _LINE.match(line)
    return found[1] if found else None


def candidates(terminal: CellTerminal, typed_line: str) -> tuple[str, list[str]]:
    """Return the word before the cursor, and the words that can replace it.

    :param terminal: the terminal of the notebook.
    :param typed_line: the words after `ros2`, up to the cursor.
    """
    *words, typed = typed_line.split(' ')
    words = [word for word in words if word]
    session = terminal.machine.session
    if words[:1] == ['view']:
        return typed, [tab for tab in TABS if tab.startswith(typed)]
    own: Iterable[str] = OWN_OPTIONS if typed.startswith('-') and words else OWN_WORDS if not words else ()
    if session is not None:
        found = completions(session, words, typed, lambda: session.index)
    else:
        found = list(ros2_words(words, typed, lambda: index_for(terminal.workspaces()), lambda command: []))
    return typed, sorted({word for word in (*found, *own) if word.startswith(typed)})


def matcher(terminal: CellTerminal) -> Any:
    """Return a matcher for IPython's completer.

    On a line of `ros2`, it suppresses all other matchers; elsewhere, it returns nothing.
    """
    from IPython.core.completer import SimpleCompletion, context_matcher

    @context_matcher(identifier='edulaunch.ros2')  # type: ignore[untyped-decorator, unused-ignore]
    def ros2(context: Any) -> Any:
        lines = context.full_text.split('\n')[: context.cursor_line + 1]
        lines[-1] = lines[-1][: context.cursor_position]
        line = unfinished('\n'.join(lines), lines[-1])
        if line is None:
            return {'completions': []}
        typed, found = candidates(terminal, line)
        return {'completions': [SimpleCompletion(word) for word in found], 'matched_fragment': typed, 'suppress': True}

    return ros2


def watch_names(shell: Any) -> None:
    """Add one line of help to each NameError and FileNotFoundError of a cell."""
    shell.set_custom_exc((NameError, FileNotFoundError), _shown)


def _shown(shell: Any, kind: type[Exception], error: Exception, trace: TracebackType, tb_offset: int | None = None) -> Any:
    """Show the error as IPython does, and the help below it."""
    lines = shell.InteractiveTB.structured_traceback(kind, error, trace, tb_offset=tb_offset)
    text = ''
    if isinstance(error, FileNotFoundError):
        text = missing_folder_help(error.filename)
    elif isinstance(error, NameError) and _in_a_cell(trace, shell.user_ns):
        text = missing_name_help(error.name or '', _last_line(trace), shell.user_ns)
    if text:
        lines = [*lines[:-1], f'{lines[-1]}\n  help: {text}']
    shell._showtraceback(kind, error, lines)
    return lines


def missing_folder_help(path: object) -> str:
    """Return a line of help for a file whose folder does not exist, or an empty string.

    The usual cause is that the cell that creates the folder was not run.
    """
    folder = os.path.dirname(os.fspath(path)) if isinstance(path, str | os.PathLike) else ''
    if not folder or os.path.isabs(folder) or os.path.isdir(folder):
        return ''
    return f'there is no folder {folder!r} yet: run the cells above first, because one of them creates it'


def missing_name_help(name: str, line: str, known: dict[str, Any]) -> str:
    """Return a line of help for a name that no cell has defined, or an empty string.

    :param name: the name.
    :param line: the line that uses the name.
    :param known: the names that the notebook has defined, with their values.
    """
    if not name:
        return ''
    if re.search(rf'\b(predict|compare|quiz|check)\(.*\b{name}\b', line) and not re.search(rf'\b{name}[.(\[]', line):
        return f'put a string in quotation marks: {name!r}'
    if name in SET_UP:
        return 'run the first cell of this lesson, which defines this name; run it again after each restart of the kernel'
    if name == 'check':
        return 'write this line above: from edulaunch import check'
    near = nearest(name, (word for word in known if not word.startswith('_') and word not in ('In', 'Out', 'exit', 'quit')))
    if near is not None:
        return f'did you mean {near}?'
    return f'run the cell that defines {name} first; if it ends with an error, fix that error'


def _last(trace: TracebackType) -> TracebackType:
    while trace.tb_next is not None:
        trace = trace.tb_next
    return trace


def _last_line(trace: TracebackType) -> str:
    last = _last(trace)
    return linecache.getline(last.tb_frame.f_code.co_filename, last.tb_lineno)


def _in_a_cell(trace: TracebackType, known: dict[str, Any]) -> bool:
    """Return whether the failing line is in the notebook, not in a library that the notebook calls."""
    return _last(trace).tb_frame.f_globals is known
