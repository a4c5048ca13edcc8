"""Whether a plain script can see the real clock: then the time of what it uses of ROS must be the real one, too."""

from __future__ import annotations

import datetime
import sys
import time
from types import FrameType

from edulaunch.processes.whose_code import is_own

CLOCKS = frozenset(map(id, (time, datetime, datetime.datetime, *filter(callable, vars(time).values()))))
"""Whoever has one of these among its global names looks at the real clock, or waits for it."""


def script_sees_the_clock() -> bool:
    """Asked from inside the script's first use of ROS. False in tests and notebooks, whose code is not run as a script: there
    simulated time passes as fast as it can.
    """
    main = getattr(sys.modules.get('__main__'), '__file__', None)
    if main is None or not is_own(main):
        return False
    frame: FrameType | None = sys._getframe(1)
    while frame is not None:
        file = frame.f_code.co_filename
        if is_own(file) and file[0] != '<' and not CLOCKS.isdisjoint(map(id, list(frame.f_globals.values()))):
            return True
        frame = frame.f_back
    return False
