"""The frozen description of a program to start. Launch actions create it, and most checks inspect it.

The module also defines the place of an action in a launch file, and the signals that a program may get. These are the
signals of Linux, even on Windows, which has only six signals.
"""

from __future__ import annotations

import sys
from collections.abc import Mapping
from types import MappingProxyType
from typing import NamedTuple


class Origin(NamedTuple):
    """The place in a student's file where a launch action or a parameter was created."""

    file: str
    line: int

    def __str__(self) -> str:
        return f'{self.file}:{self.line}'


class ProcessSpec(NamedTuple):
    """The description of a program before it starts.

    :ivar argv: the command line, program first, exactly as the launch action resolved it.
    :ivar name: the launch name, such as 'talker-1'.
    :ivar cwd: the working folder, or None for the launcher's working folder.
    :ivar env: the whole environment of the program, or None for a copy of the launcher's environment.
    :ivar shell: whether a shell runs the joined command line.
    :ivar origin: the launch file and line of the action.
    :ivar package: the package of a Node action.
    :ivar executable: the executable of a Node action.
    :ivar parameter_origins: the origin of the value of each parameter of a Node action, in words.
    :ivar emulate_tty: whether a real program writes to a terminal instead of pipes. A simulated program always writes as if to a
        terminal.
    :ivar has_pipe: whether the program reads from a pipe to which its parent never writes. Otherwise, the program reads an
        empty file.
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
