"""What is said to help, below an error: whoever looks on reads it there, but it is no output of a program and not recorded.

So recordings are the same in every language, and a launch file's handlers of output see what they see in ROS 2.
"""

from __future__ import annotations

import re
from collections import deque
from collections.abc import Mapping
from typing import Any, NamedTuple

from edulaunch.engine.attached import attached

MOST_DUE = 50
_COLOUR = re.compile(r'\x1b\[[0-9;]*m')
_PREFIX = re.compile(r'\[[^\]]*\] ')


class _Due(NamedTuple):
    """An error whose last line is on its way to those who look on; `told` has the numbers of the programs below which it was.

    `group` is the number of the program in whose terminal it happened.
    """

    last_line: str
    group: int
    error: dict[str, Any]
    told: set[int]


class Asides:
    """Of one simulated machine: errors that are to be followed by help where they come to a console.

    :ivar helped: the programs whose error somebody has read with help below.
    """

    def __init__(self) -> None:
        self.due: deque[_Due] = deque(maxlen=MOST_DUE)
        self.helped: set[str] = set()

    def expect(self, text: str, error: dict[str, Any], group: int) -> None:
        """An error is going to be written.

        :param text: what is written; its last line is waited for.
        :param error: type, message, file, line, facts and process, as plain data.
        :param group: number of the program that a terminal started, in whose terminal this happens.
        """
        lines = [line for line in text.splitlines() if line.strip()]
        if lines:
            self.due.append(_Due(lines[-1], group, error, set()))

    def below(self, text: str, pid: int, env: Mapping[str, str]) -> str:
        """What to say below a text that has just come to the console of a program; '' when there is nothing to say.

        :param pid: of that program; `env`: its environment, which tells who reads.
        """
        lines = _COLOUR.sub('', text).splitlines()
        # Another terminal's error may have ended with the same line, for another reason.
        for due in sorted(self.due, key=lambda due: due.group != pid):
            line = next((line for line in lines if line.endswith(due.last_line)), None)
            if line is not None and pid not in due.told:
                due.told.add(pid)
                words = attached('help_below')(due.error, env)
                prefix = _PREFIX.match(line)
                is_launch = due.error.get('process') is None
                if words is None:
                    return ''
                self.helped.add(due.error.get('process') or '')
                return f'{prefix[0] if prefix and not is_launch else ""}  help: {words}\n'
        return ''
