"""Keeps simulated time equal to real time while programs wait for the real world, such as a real program or a person at a
keyboard.
"""

from __future__ import annotations

import time
from collections.abc import Callable

from edulaunch.engine.sim.simulation import Simulation

LOOK_EVERY_NS = 10_000_000
"""Simulated time keeps this close to real time."""
SILENCE_NS = 10**9


class RealPace:
    """A clock that is shared by all waits for the real world. Whatever the number of these waits, simulated time passes like
    real time.

    :param sim: the simulation.
    :param clock: a function that returns the real time in ns; tests replace it.
    """

    def __init__(self, sim: Simulation, clock: Callable[[], int] = time.monotonic_ns) -> None:
        self._sim = sim
        self._clock = clock
        self._anchor = self._last = sim.now_ns, clock()

    def begin(self) -> None:
        """Make simulated time follow real time from now on, starting from the current values of both times."""
        self._anchor = self._last = self._sim.now_ns, self._clock()

    def ahead_s(self) -> float:
        """Return the seconds to wait until real time reaches simulated time.

        If more than a second has passed since the last call, start again from the current values.
        """
        now, real = self._sim.now_ns, self._clock()
        if now - self._last[0] > SILENCE_NS or real - self._last[1] > SILENCE_NS:
            self._anchor = now - LOOK_EVERY_NS, real
        self._last = now, real
        return max(0, (now - self._anchor[0]) - (real - self._anchor[1])) / 1e9
