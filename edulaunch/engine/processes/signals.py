"""The signals of a program: its handlers, and the effect of signals without a handler."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from edulaunch.engine.processes.frame_owner import waiting_line
from edulaunch.engine.processes.lifecycle import Lifecycle
from edulaunch.engine.processes.spec import Signals
from edulaunch.engine.sim.task import running_task

DEADLY = (Signals.SIGKILL, Signals.SIGTERM, Signals.SIGQUIT, Signals.SIGHUP, Signals.SIGALRM, Signals.SIGUSR1, Signals.SIGUSR2)
"""Signals that end a program without a handler for them."""
FORCED = (Signals.SIGTERM, Signals.SIGKILL)
"""Signals that are sent to a program that does not end by itself."""


class SignalDelivery:
    """The delivery of signals to one program.

    :param lifecycle: the lifecycle of the program.
    :param note_force: called before a signal of `FORCED` is delivered, with the signal and the place where each thread waits.
    :ivar handlers: the program's handlers, by the number of the signal.
    """

    def __init__(self, lifecycle: Lifecycle, note_force: Callable[[int, list[dict[str, Any]]], object]) -> None:
        self.handlers: dict[int, Callable[[int], object]] = {}
        self._lifecycle = lifecycle
        self._note_force = note_force

    def deliver(self, signum: int) -> None:
        """Deliver a signal to the program. Do nothing if the program has ended.

        The handler of the program runs where the program waits. Without a handler, SIGINT raises KeyboardInterrupt there.
        The signals of DEADLY end the program, and all other signals are ignored. If a program sends a signal to itself, the
        signal takes effect before this call returns.
        """
        signum, task = int(signum), self._lifecycle.task
        if self._lifecycle.returncode is not None:
            return
        if signum in FORCED:
            self._note_force(signum, self._waits())
        handler = self.handlers.get(signum)
        if handler is not None and signum != Signals.SIGKILL:
            task.interrupt(lambda: handler(signum))
        elif signum == Signals.SIGINT:
            task.interrupt(_raise_keyboard_interrupt)
        elif signum in DEADLY:
            self.die_of(signum)
        if running_task() is task:
            task.attend()

    def _waits(self) -> list[dict[str, Any]]:
        """Return the place where each thread of the program waits, beginning with the main thread."""
        tasks = (self._lifecycle.task, *self._lifecycle.threads)
        return [{'thread': task.name, **waiting_line(task)} for task in tasks if not task.finished]

    def die_of(self, signum: int) -> None:
        """End the program with a signal that has no handler. No `finally` block has an effect."""
        self._lifecycle.killed_by = signum
        self._lifecycle.vanish()

    def die_at_once(self, signum: int) -> None:
        """End the program with a signal immediately. Only the program itself may call this."""
        self.die_of(signum)
        self._lifecycle.task.attend()


def _raise_keyboard_interrupt() -> None:
    raise KeyboardInterrupt
