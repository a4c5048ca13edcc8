"""Parking: blocking code ends its turn, and gets another turn later.

A task is a greenlet, so that unmodified code may block anywhere in its call stack. Exactly one task runs at a time, and the
agenda decides which one. All blocking (sleeping, locks, waiting for a message) uses `park` and `wake`.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from edulaunch.engine.sim.simulation import Item, Simulation

POLLS_BEFORE_TIME_PASSES = 1000
POLLS_AFTER_THAT = 20
POLL_PAUSE_NS = 1_000_000


class TaskKilled(BaseException):
    """Raised inside a task that is being killed. A program cannot continue after this exception."""


class Parking:
    """The part of a task that handles waiting. `task.py` handles the start and the end of the program."""

    def __init__(self, sim: Simulation) -> None:
        self.sim = sim
        self.loop: Any = None
        self._greenlet: Any = None
        self._parked = False
        self._woken = False
        self._killed = False
        self._interrupts: list[Callable[[], object]] = []
        self._timer: Item | None = None
        self._polls = 0
        self._soon = sim._soon
        self._turn: Item = [sim.start_ns, 0, 0, None]

    def park(self, deadline_ns: int | None = None) -> bool:
        """End the turn until :meth:`wake` is called, or until the simulated time is `deadline_ns`.

        If the task was woken after its last park, return immediately. So callers must check their condition again.

        :param deadline_ns: a simulated time in nanoseconds, or None to wait without limit.
        :returns: True if the task was woken, False if the deadline came first.
        :raises TaskKilled: if the task is killed. An :meth:`interrupt` may raise other exceptions.
        """
        self._polls = 0
        # set before `_woken` is read, because a wake in another thread reads and sets them in the opposite order
        self._parked = True
        if not self._woken and not self._killed:
            timer = self._timer
            if timer is not None if deadline_ns is None else timer is None or timer[0] != deadline_ns:
                self._set_timer(deadline_ns)
            sim, soon = self.sim, self._soon
            agenda = sim.agenda
            if self.loop is not None:
                self.loop.step_aside(sim.hub.switch)
            elif soon and not soon[0][2] and sim.hands_on and not (agenda and agenda[0][0] == sim.now_ns):
                # Another task's turn is next (turns have the sequence number 0), so switch to it directly instead of to the hub.
                # This saves a third of all switches where tasks wake each other (2 % of the large project).
                soon.popleft()[3]()
            else:
                sim.hub.switch()
        self._parked = False
        woken = self._woken
        if woken:
            self._woken = False
        if self._killed:
            raise TaskKilled
        if self._interrupts:
            self._deliver_interrupts()
        if not woken and (deadline_ns is None or self._timer is not None):  # an earlier wake left this turn on the agenda
            return self.park(deadline_ns)
        return woken

    def suspend(self) -> None:
        """Stop the whole simulation in the middle of this turn, so that `run` or `step` returns. The next call of `run` or
        `step` continues here.

        The agenda contains no item for this, so the recording of the run does not change.
        """
        sim = self.sim
        sim.suspend(self._greenlet.switch)
        if self.loop is None:
            sim.hub.switch()
        else:
            self.loop.step_aside(sim.hub.switch)
        if self._killed:
            raise TaskKilled

    def waits_for_ever(self) -> bool:
        """Return whether the task is parked without a deadline and has not been woken."""
        return self._parked and self._timer is None and not self._woken

    def _set_timer(self, deadline_ns: int | None) -> None:
        if self._timer is not None:
            self._timer[3] = None
            self._timer = None
        if deadline_ns is not None:
            sim = self.sim
            self._timer = sim.schedule(deadline_ns if deadline_ns > sim.now_ns else sim.now_ns, self._on_timer)

    def _on_timer(self) -> None:
        self._timer = None
        if self._parked and not self._woken:
            self._greenlet.switch()

    def wake(self) -> None:
        """Make the task run again, after everything that is already due at this instant.

        A second call before the task runs has no effect. A real thread may call this at any moment, and no call is lost.
        """
        if not self._woken:
            self._woken = True
            if self._parked:
                self._soon.append(self._turn)

    def interrupt(self, action: Callable[[], object]) -> None:
        """Run `action` inside the task where the task is parked (or will park next), so that exceptions of `action` are raised
        there.
        """
        self._interrupts.append(action)
        self.wake()

    def _deliver_interrupts(self) -> None:
        while self._interrupts:
            self._interrupts.pop(0)()

    def attend(self) -> None:
        """Handle earlier calls of :meth:`interrupt` and :meth:`kill` now. Without this call, the task handles them when it
        parks next.

        Only the task itself may call this.
        """
        if self._killed:
            raise TaskKilled
        self._deliver_interrupts()

    def kill(self) -> None:
        """End the task: from now on, each call of `park` raises `TaskKilled`."""
        self._killed = True
        self.wake()

    def poll(self) -> None:
        """Count a reading of the clock, so that simulated time passes for a program that reads the clock and never blocks.

        At first, time passes after many readings, and later after fewer readings, until the program really blocks. If
        simulated time follows a real clock, it is updated first.
        """
        if self.sim.keep_up is not None:
            self.sim.keep_up()
        self._polls += 1
        if self._polls > POLLS_BEFORE_TIME_PASSES:
            self.sleep_until(self.sim.now_ns + POLL_PAUSE_NS)
            self._polls = POLLS_BEFORE_TIME_PASSES - POLLS_AFTER_THAT

    def sleep_until(self, at_ns: int) -> None:
        """Park until the simulated time is `at_ns`, even if the task is woken earlier. The task ends its turn at least once."""
        sim = self.sim
        missed = self.park(at_ns)
        while sim.now_ns < at_ns:
            missed = self.park(at_ns) or missed
        if missed:
            self._woken = True
