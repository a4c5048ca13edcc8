"""Deferred hints: the hint for an error appears later than the error arises, where the last line of its text reaches a console.

A hint is not output of a program and is not recorded. So recordings are the same in every language, and a launch file's handlers
of output receive the same output as in ROS 2.
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
    """An error whose last line is on its way to the consoles.

    :ivar group: the number of the program in whose terminal the error happened.
    :ivar shown_to: the numbers of the programs below whose output the hint has appeared.
    """

    last_line: str
    group: int
    error: dict[str, Any]
    shown_to: set[int]


class DeferredHints:
    """The hints of one simulated machine.

    :param hint_of: returns the line below an error; with None, no error has a hint.
    """

    def __init__(self, hint_of: HintOf | None = None) -> None:
        self.pending: deque[_Pending] = deque(maxlen=MOST_PENDING)
        self._helped: set[tuple[int, str]] = set()
        self._hint_of = hint_of

    def expect(self, text: str, error: dict[str, Any], group: int) -> None:
        """Record an error that will be written.

        :param text: the output; the hint waits for its last line.
        :param error: type, message, file, line, facts and process, as plain data.
        :param group: number of the program that the terminal of the error started.
        """
        lines = [line for line in text.splitlines() if line.strip()]
        if lines and self._hint_of is not None:
            self.pending.append(_Pending(lines[-1], group, error, set()))

    def helped(self, group: int) -> set[str]:
        """Return the programs of one terminal below whose error a hint has appeared.

        :param group: number of that program.
        """
        return {process for pid, process in self._helped if pid == group}

    def below(self, text: str, pid: int, env: Mapping[str, str]) -> str:
        """Return the hint below the last output in the console of a program, or ''.

        :param pid: the number of that program.
        :param env: its environment, which sets the language of the reader.
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
