"""The limit on a program's output.

A loop that writes and never waits would fill the memory long before the watchdog notices the loop. Other programs would have to
read all of this output.
"""

from __future__ import annotations

from edulaunch.engine.sim.simulation import Simulation

MOST_WRITES = 10_000
MOST_TEXT = 4_000_000
"""The number of writes and characters that a program may write at one instant, and for each program that it has started."""


class WriteLimit:
    """A counter of the output that one program writes at one instant of simulated time.

    :ivar programs: the number of programs whose output this program may write, including itself.
    :ivar writes: the number of writes at this instant.
    """

    def __init__(self, sim: Simulation) -> None:
        self.programs = 1
        self.writes = 0
        self._sim = sim
        self._instant_ns = 0
        self._characters = 0

    def is_exceeded_by(self, text: str) -> bool:
        """Add a string to the count, and return whether the count exceeds the limit."""
        if self._instant_ns != self._sim.now_ns:
            self._instant_ns, self.writes, self._characters = self._sim.now_ns, 0, 0
        self.writes += 1
        self._characters += len(text)
        return self.writes > MOST_WRITES * self.programs or self._characters > MOST_TEXT * self.programs

    def reset(self) -> None:
        """Set the count to zero."""
        self._instant_ns = 0
