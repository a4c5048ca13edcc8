"""The signals of the simulated machine, which is a Linux: also on a Windows, which has six of its own."""

from __future__ import annotations

import sys

if sys.platform != 'win32':
    from signal import Signals as Signals
else:
    from enum import IntEnum

    NAMES = (
        'HUP INT QUIT ILL TRAP ABRT BUS FPE KILL USR1 SEGV USR2 PIPE ALRM TERM STKFLT CHLD CONT STOP TSTP TTIN TTOU '
        'URG XCPU XFSZ VTALRM PROF WINCH IO PWR SYS'
    )
    Signals = IntEnum('Signals', [f'SIG{name}' for name in NAMES.split()])
