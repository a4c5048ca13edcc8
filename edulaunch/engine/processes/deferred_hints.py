"""Deferred hints: the hint for an error appears later than the error, when the last line of the error reaches a console.

A hint is not output of a program and is not recorded. So recordings are the same in every language, and a launch file's output
event handlers receive the same output as in ROS 2.
"""

from __future__ import annotations

import re
from collections import deque
from collections.abc import Callable, Mapping
from typing import Any, NamedTuple

MOST_PENDING = 50
_COLOUR = re.compile(r'\x1b\[[0-9;]*m')
_PREFIX = re.compile(r'\[[^\]]*\] ')

HintOf = Callable[[dict[str, Any], Mapping[str, str]], 'str | None']
"""Returns the line below an error or None, given the error as plain data and the environment of the reader."""


class _Pending(NamedTuple):
    """An error whose last line has not yet reached all consoles.

    :ivar group: the number of the program in whose terminal the error occurred.
    :ivar shown_to: the numbers of the programs below whose output the hint has appeared.
    """

    last_line: str
    group: int
    error: dict[str, Any]
    shown_to: set[int]


class DeferredHints:
    """The hints of one simulated machine, which wait until their errors appear on a console.

    :param hint_of: a function that returns the hint for an error; with None, no error has a hint.
    """

    def __init__(self, hint_of: HintOf | None = None) -> None:
        self.pending: deque[_Pending] = deque(maxlen=MOST_PENDING)
        self._helped: set[tuple[int, str]] = set()
        self._hint_of = hint_of

    def expect(self, text: str, error: dict[str, Any], group: int) -> None:
        """Record an error that is about to be written.

        :param text: the output; the hint is shown below its last line.
        :param error: type, message, file, line, facts and process of the error, as plain data.
        :param group: the number of the program that was started in the terminal in which the error occurs.
        """
        lines = [line for line in text.splitlines() if line.strip()]
        if lines and self._hint_of is not None:
            self.pending.append(_Pending(lines[-1], group, error, set()))

    def helped(self, group: int) -> set[str]:
        """Return the names of the programs in one terminal for whose error a hint has appeared.

        :param group: the number of the program that was started in the terminal.
        """
        return {process for pid, process in self._helped if pid == group}

    def below(self, text: str, pid: int, env: Mapping[str, str]) -> str:
        """Return the hint to show below the last output in the console of a program, or '' without a hint.

        :param text: the last output.
        :param pid: the number of the program.
        :param env: the environment of the program, which sets the language of the hint.
        """
        lines = _COLOUR.sub('', text).splitlines()
        # Prefer this terminal's error: another terminal may have shown the same last line for another reason.
        for pending in sorted(self.pending, key=lambda pending: pending.group != pid):
            line = next((line for line in lines if line.endswith(pending.last_line)), None)
            if line is not None and pid not in pending.shown_to:
                pending.shown_to.add(pid)
                hint = None if self._hint_of is None else self._hint_of(pending.error, env)
                if hint is None:
                    return ''
                process = pending.error.get('process')
                self._helped.add((pending.group, process or ''))
                prefix = _PREFIX.match(line) if process is not None else None
                return f'{prefix[0] if prefix else ""}{hint}\n'
        return ''
