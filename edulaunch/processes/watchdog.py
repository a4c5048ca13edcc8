"""Stops programs that never give their turn back, such as `while True: pass`.

A thread looks every now and then at what the simulation's thread is doing. Nothing is counted or checked while programs run, so
this costs them nothing.
"""

from __future__ import annotations

import ctypes
import sys
import threading
import weakref
from typing import Any

from edulaunch.sim.simulation import Simulation
from edulaunch.sim.task import Task

LOOKS = 10
"""How many times in a row the same program must be seen at the same step."""


class RunawayProgram(BaseException):
    """Raised inside a program that kept its turn for too long, wherever it is; no `except Exception` of the program stops it."""

    def __str__(self) -> str:
        return 'the program never gave its turn back and was stopped'


class Watchdog:
    """Watches one simulation.

    :param seconds: how long (real time) a program may keep its turn.
    :ivar thread: number of the thread in which the simulation runs; None before it does.
    :ivar asleep: somebody waits for a person at a real keyboard, which may take any time.
    """

    def __init__(self, sim: Simulation, seconds: float) -> None:
        self.seconds = seconds
        self.thread: int | None = None
        self.asleep = False
        self._sim = weakref.ref(sim)
        self._over = threading.Event()
        self._started = False

    def start(self) -> None:
        """Begin to watch; doing it twice is doing it once."""
        if not self._started:
            self._started = True
            threading.Thread(target=self._watch, name='edulaunch watchdog', daemon=True).start()

    def stop(self) -> None:
        """Watch no longer."""
        self._over.set()

    def _watch(self) -> None:
        seen: Any = None
        times = 0
        while not self._over.wait(self.seconds / LOOKS):
            sim = self._sim()
            if sim is None:
                return
            task = self._running_task()
            now = (sim.now_ns, sim._sequence, task)
            times = times + 1 if task is not None and now == seen and not self.asleep else 0
            seen = now
            if times >= LOOKS and self._running_task() is task:
                # This thread has just got the interpreter, and keeps it for longer than these two lines take.
                ctypes.pythonapi.PyThreadState_SetAsyncExc(ctypes.c_ulong(self.thread or 0), ctypes.py_object(RunawayProgram))
            del sim

    def _running_task(self) -> Task | None:
        """The task that has its turn, found at the bottom of what the simulation's thread executes; None on the hub."""
        frame = sys._current_frames().get(self.thread or 0)
        while frame is not None:
            if frame.f_code is Task._run.__code__:
                task: Task = frame.f_locals['self']
                return task
            frame = frame.f_back
        return None
