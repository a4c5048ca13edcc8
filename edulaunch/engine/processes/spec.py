"""The frozen description of a program to start. Launch actions create it, and most checks judge it. It includes its place in the
launch file, and the signals that it may get: those of Linux, even on Windows, which has only six.
"""

from __future__ import annotations

import sys
from collections.abc import Mapping
from types import MappingProxyType
from typing import NamedTuple


class Origin(NamedTuple):
    """The place in a student's file that created a launch action or a parameter."""

    file: str
    line: int

    def __str__(self) -> str:
        return f'{self.file}:{self.line}'


class ProcessSpec(NamedTuple):
    """Everything that is known before a program starts.

    :ivar argv: the command line, program first, exactly as the launch action resolved it.
    :ivar name: the launch name, such as 'talker-1'.
    :ivar cwd: working directory, None for the launcher's own.
    :ivar env: the whole environment of the program; None for a copy of the launcher's.
    :ivar shell: whether the joined command line goes through the shell.
    :ivar origin: the launch file and line of the action.
    :ivar package, executable: those of a Node action.
    :ivar parameter_origins: for each parameter of a Node action, where its value came from, in words.
    :ivar emulate_tty: whether a real program writes to a terminal instead of pipes; a simulated one writes as if to one anyway.
    :ivar has_pipe: whether it reads from a pipe of its parent, which is never written to; otherwise, it reads an empty file.
    """

    argv: tuple[str, ...]
    name: str = 'process'
    cwd: str | None = None
    env: Mapping[str, str] | None = None
    shell: bool = False
    origin: Origin | None = None
    package: str | None = None
    executable: str | None = None
    parameter_origins: Mapping[str, str] = MappingProxyType({})
    emulate_tty: bool = False
    has_pipe: bool = False


if sys.platform != 'win32':
    from signal import Signals as Signals
else:
    from enum import IntEnum

    NAMES = (
        'HUP INT QUIT ILL TRAP ABRT BUS FPE KILL USR1 SEGV USR2 PIPE ALRM TERM STKFLT CHLD CONT STOP TSTP TTIN TTOU '
        'URG XCPU XFSZ VTALRM PROF WINCH IO PWR SYS'
    )
    Signals = IntEnum('Signals', [f'SIG{name}' for name in NAMES.split()])
