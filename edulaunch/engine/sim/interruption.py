"""Handling of Ctrl-C and of the interrupt button of a notebook while simulated time passes."""

from __future__ import annotations

import signal
import threading
from collections.abc import Callable
from types import FrameType, TracebackType
from typing import Any

from edulaunch.engine.sim.simulation import Simulation


class Interruption:
    """A context manager in which the first SIGINT stops the simulation between two steps, and the second SIGINT raises
    KeyboardInterrupt.

    Python's own handler would raise KeyboardInterrupt in the code that runs. This may be a simulated program, which would
    handle it as its own Ctrl-C while the run continues, or the middle of the engine. If other code handles SIGINT, or outside
    the main thread, the context manager has no effect.

    :param sim: the simulation to stop.
    :param on_first: called at the first SIGINT.
    :ivar came: whether a SIGINT has arrived.
    """

    def __init__(self, sim: Simulation, on_first: Callable[[], object] = lambda: None) -> None:
        self.came = False
        self._on_first = on_first
        self._sim = sim
        self._before: Any = None

    def __enter__(self) -> Interruption:
        in_main = threading.current_thread() is threading.main_thread()
        if in_main and signal.getsignal(signal.SIGINT) is signal.default_int_handler:
            self._before = signal.signal(signal.SIGINT, self._press)
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None) -> None:
        if self._before is not None:
            signal.signal(signal.SIGINT, self._before)

    def _press(self, signum: int, frame: FrameType | None) -> None:
        if self.came:
            raise KeyboardInterrupt
        self.came = True
        self._sim.stop()
        self._on_first()
