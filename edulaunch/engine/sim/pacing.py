"""Keeps a simulation in pace with a real clock, by waiting between its steps."""

from __future__ import annotations

import time
from collections.abc import Callable

from edulaunch.engine.sim.simulation import Simulation

LONGEST_WAIT_S = 0.05
SLICE_S = 0.02
"""Simulated seconds (at speed 1) after which the owner of a :class:`RealTime` has its turn."""
FALLS_BEHIND_S = 0.25
"""The most real seconds that simulated time catches up. A longer delay (a sleeping computer, slow programs) remains."""


class Pacer:
    """Runs a simulation at a given speed.

    :param sim: the simulation.
    :param speed: simulated seconds per real second; 0 means as fast as possible.
    :param clock: a function that returns the real time in seconds; tests replace it.
    :param wait: a function that waits for a number of real seconds; tests replace it.
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
        """Run until `until_ns`, until `is_over()` is true, or until the agenda is empty.

        :param until_ns: a simulated time in nanoseconds, or None for no limit.
        """
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
        """Wait until the real clock has reached the end, because no item is due before."""
        if until_ns is None or is_over():
            return
        while self.speed and not is_over():
            ahead = (until_ns - began_ns) / 1e9 / self.speed - (self._clock() - began_s)
            if ahead <= 0:
                break
            self._wait(min(ahead, LONGEST_WAIT_S))
        if not is_over():
            self.sim.run(until_ns)


class RealTime:
    """Simulated time that follows a real clock while its owner does other things.

    The owner repeatedly calls :meth:`advance`, and then waits at most for the returned time.

    :param sim: the simulation.
    :param speed: simulated seconds per real second.
    :param clock: a function that returns the real time in seconds; tests replace it.
    """

    def __init__(self, sim: Simulation, speed: float = 1.0, *, clock: Callable[[], float] = time.monotonic) -> None:
        self.sim = sim
        self._clock = clock
        self._speed = speed
        self._paused = False
        self._began = sim.now_ns, clock()
        self._is_wall = False

    @property
    def is_wall(self) -> bool:
        """Whether simulated time equals real time, as communication with the real world requires.

        If so, simulated time catches up after every delay. It cannot be paused, and the speed has no effect.
        """
        return self._is_wall

    @is_wall.setter
    def is_wall(self, is_wall: bool) -> None:
        self._is_wall, self._paused = is_wall, False
        if is_wall:
            self._began = time.time_ns(), self._clock()
            self.sim.leap(self._due_ns())
        else:
            self.go_on()

    @property
    def speed(self) -> float:
        """Simulated seconds per real second."""
        return self._speed

    @speed.setter
    def speed(self, speed: float) -> None:
        self._speed = speed
        self.go_on()

    @property
    def paused(self) -> bool:
        """Whether simulated time is paused."""
        return self._paused

    @paused.setter
    def paused(self, paused: bool) -> None:
        self._paused = paused and not self._is_wall
        self.go_on()

    def go_on(self) -> None:
        """Make simulated time follow real time from now on, without catching up on the real time that has already passed."""
        if not self._is_wall:
            self._began = self.sim.now_ns, self._clock()

    def advance(self) -> float | None:
        """Run the items that are due, but only for a short time. Return the real seconds until the next item is due.

        Return None if the agenda is empty or simulated time is paused.
        """
        sim = self.sim
        if self._paused:
            if not sim.is_suspended:
                sim.run(sim.now_ns)  # a process that has just started may report that it waits
            return None
        next_ns = sim.next_time_ns()
        if next_ns is not None and self._due_ns() - next_ns > FALLS_BEHIND_S * 1e9 * self._pace:
            if self._is_wall:
                sim.leap(sim.now_ns + self._due_ns() - next_ns)
                next_ns = sim.next_time_ns() or sim.now_ns
            else:
                self._began = next_ns, self._clock() - FALLS_BEHIND_S
        due_ns = max(sim.now_ns, self._due_ns())
        sim.run(due_ns if next_ns is None else min(due_ns, max(next_ns, sim.now_ns) + round(SLICE_S * 1e9 * self._pace)))
        if sim.is_suspended:
            self.paused = True
        next_ns = sim.next_time_ns()
        return None if next_ns is None else max(0.0, (next_ns - self._due_ns()) / 1e9 / self._pace)

    @property
    def _pace(self) -> float:
        return 1.0 if self._is_wall else self._speed

    def _due_ns(self) -> int:
        """Return the simulated time that belongs to the current real time."""
        began_ns, began_s = self._began
        return began_ns + round((self._clock() - began_s) * 1e9 * self._pace)
