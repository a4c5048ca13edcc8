"""Real time as an add-on: waiting between the steps of a simulation so that it keeps pace with a clock on the wall."""

from __future__ import annotations

import time
from collections.abc import Callable

from edulaunch.sim.simulation import Simulation

LONGEST_WAIT_S = 0.05


class Pacer:
    """Runs a simulation at `speed` simulated seconds per real second; 0 means as fast as possible.

    :param clock, wait: what tells and lets pass real time, in seconds (for tests).
    """

    def __init__(
        self,
        sim: Simulation,
        speed: float = 1.0,
        *,
        clock: Callable[[], float] = time.monotonic,
        wait: Callable[[float], object] = time.sleep,
    ) -> None:
        self.sim = sim
        self.speed = speed
        self._clock = clock
        self._wait = wait

    def run(self, until_ns: int | None, is_over: Callable[[], bool]) -> None:
        """Run until `until_ns`, until `is_over()` is true, or until nothing is left to do."""
        sim = self.sim
        began_ns, began_s = sim.now_ns, self._clock()
        while not is_over():
            next_ns = sim.next_time_ns()
            if next_ns is None or (until_ns is not None and next_ns > until_ns):
                self._hold(until_ns, began_ns, began_s, is_over)
                break
            if self.speed:
                ahead = (next_ns - began_ns) / 1e9 / self.speed - (self._clock() - began_s)
                if ahead > 0:
                    self._wait(min(ahead, LONGEST_WAIT_S))
                    if ahead > LONGEST_WAIT_S:
                        continue
            sim.step()

    def _hold(self, until_ns: int | None, began_ns: int, began_s: float, is_over: Callable[[], bool]) -> None:
        """Nothing happens until the end: wait for the clock to get there."""
        if until_ns is None or is_over():
            return
        while self.speed and not is_over():
            ahead = (until_ns - began_ns) / 1e9 / self.speed - (self._clock() - began_s)
            if ahead <= 0:
                break
            self._wait(min(ahead, LONGEST_WAIT_S))
        if not is_over():
            self.sim.run(until_ns)
