"""The Tab key behind `%ros2`: what could stand there, on the machine as it is now."""

from __future__ import annotations

import re
from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

from edulaunch.attached import attached
from edulaunch.session import index_for
from edulaunch.view import TABS
from edulaunch.view.completing import completions

if TYPE_CHECKING:
    from edulaunch.jupyter.terminal import Terminal

_LINE = re.compile(r'(?:^|.*=)\s*%{1,2}ros2\s+(.*)$')
OWN_WORDS = ('view', 'jobs', 'stop', 'wait')
OWN_OPTIONS = ('--for', '--seed', '--quiet')


def unfinished(text: str, line: str) -> str | None:
    """What stands behind `ros2` on an unfinished line of a cell; None for a line that is Python.

    :param text: the cell up to the cursor.
    :param line: the last line of that.
    """
    if text.startswith('%%ros2') and '\n' in text:
        return line.lstrip()
    found = _LINE.match(line)
    return found[1] if found else None


def candidates(terminal: Terminal, typed_line: str) -> tuple[str, list[str]]:
    """The word that is being typed, and those that it could become."""
    *words, typed = typed_line.split(' ')
    words = [word for word in words if word]
    session = terminal.machine.session
    if words[:1] == ['view']:
        return typed, [tab for tab in TABS if tab.startswith(typed)]
    own: Iterable[str] = OWN_OPTIONS if typed.startswith('-') and words else OWN_WORDS if not words else ()
    if session is not None:
        found = completions(session, words, typed)
    else:
        found = attached('completions')(words, typed, lambda: index_for(terminal.workspaces()), lambda command: [])
    return typed, sorted({word for word in (*found, *own) if word.startswith(typed)})


def matcher(terminal: Terminal) -> Any:
    """A matcher for IPython's completer: alone on a line of `ros2`, silent elsewhere."""
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
