"""Keeps simulated time equal to real time while programs wait for the real world, such as real programs or a person at a
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
    """One clock for all that wait for the real world. With any number of them, simulated time passes like real time.

    :param clock: reads real time in ns (for tests).
    """

    def __init__(self, sim: Simulation, clock: Callable[[], int] = time.monotonic_ns) -> None:
        self._sim = sim
        self._clock = clock
        self._anchor = self._last = sim.now_ns, clock()

    def begin(self) -> None:
        """Let simulated and real time pass together from now on, starting from their current values."""
        self._anchor = self._last = self._sim.now_ns, self._clock()

    def ahead_s(self) -> float:
        """Return how long to wait until real time reaches simulated time. After a second without a call, both start together
        again.
        """
        now, real = self._sim.now_ns, self._clock()
        if now - self._last[0] > SILENCE_NS or real - self._last[1] > SILENCE_NS:
            self._anchor = now - LOOK_EVERY_NS, real
        self._last = now, real
        return max(0, (now - self._anchor[0]) - (real - self._anchor[1])) / 1e9
