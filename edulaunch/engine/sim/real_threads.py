"""Real threads of a plain script that use ROS in addition to the main thread.

In a plain script, `threading` is Python's own module, so `threading.Thread(target=rclpy.spin, args=(node,))` is a real
thread. Such threads take part in the simulation of the main thread. Only the main thread runs items of the agenda. The other
threads wait in real time until they are woken or their deadline comes. While there is such a thread, simulated time keeps
pace with real time, and runs do not repeat exactly.
"""

from __future__ import annotations

import threading
import time
from collections.abc import Callable

from edulaunch.engine.sim.task import AmbientTask, Task, TaskKilled, current_task

LOOK_EVERY_S = 0.01
THREAD_BEGINS_S = 0.02


class RealThreads:
    """The threads that take part in a main thread's simulation, and the clock that they share.

    :param host: the task of the main thread.
    """

    def __init__(self, host: AmbientTask) -> None:
        self._host = host
        self._threads: list[threading.Thread] = []
        self._bell = threading.Event()
        self._setting_time = threading.Lock()
        self._anchor = host.sim.now_ns, time.monotonic_ns()
        self._keeps_time = False

    def keep_time(self) -> None:
        """Make simulated time equal to real time from now on, even without other threads. Call this before the simulation
        starts.
        """
        sim = self._host.sim
        if sim.next_time_ns() is None and sim.now_ns == sim.start_ns:
            sim.start_ns = sim.now_ns = time.time_ns()
        self._anchor, self._keeps_time = (sim.now_ns, time.monotonic_ns()), True
        sim.keep_up = self.now_ns

    def set_the_pace(self, due_ns: int | None) -> bool:
        """Return whether the main thread must wait in real time for its next item.

        :param due_ns: the simulated time of the item in nanoseconds, or None if there is no item.
        """
        return self.are_here() or (self._keeps_time and due_ns is not None)

    def let_begin(self) -> None:
        """Wait for a moment, in which threads that have just been started can run."""
        time.sleep(THREAD_BEGINS_S)

    def join(self) -> RealThreadTask:
        """Add the running thread to the simulation, and return its task."""
        return RealThreadTask(self._host, self)

    def add(self, thread: threading.Thread) -> None:
        """Add a thread. If it is the only thread, simulated time follows real time from its current value."""
        if not self.are_here():
            self._anchor = self._host.sim.now_ns, time.monotonic_ns()
        self._threads.append(thread)

    def are_here(self) -> bool:
        """Return whether any of the threads is still running."""
        self._threads = [thread for thread in self._threads if thread.is_alive()]
        return bool(self._threads)

    def now_ns(self) -> int:
        """Update simulated time to the current real time, and return it. Simulated time never decreases, whichever thread
        calls this.
        """
        with self._setting_time:
            sim, here = self._host.sim, time.monotonic_ns()
            now = self._anchor[0] + here - self._anchor[1]
            if sim.now_ns > now:
                now = sim.now_ns
                self._anchor = now, here
            sim.now_ns = now
            return now

    def ring(self) -> None:
        """Make the main thread check its condition again immediately."""
        self._bell.set()

    def await_turn(self, due_ns: int | None) -> bool:
        """Return whether an item is due. If it is not, wait for a moment, or until :meth:`ring` is called, and return False.

        :param due_ns: the simulated time of the item in nanoseconds, or None if there is no item.
        """
        now = self.now_ns()
        if due_ns is not None and now >= due_ns:
            return True
        self._bell.wait(LOOK_EVERY_S if due_ns is None else min(LOOK_EVERY_S, (due_ns - now) / 1e9))
        self._bell.clear()
        return False


class RealThreadTask(AmbientTask):
    """The task that represents a real thread in the simulation of the main thread."""

    is_real_thread = True

    def __init__(self, host: AmbientTask, clock: RealThreads) -> None:
        super().__init__(host.sim, owner=host.owner)
        self.name = threading.current_thread().name
        self._bell = threading.Event()
        self._clock = clock
        self._clock.add(threading.current_thread())

    def park(self, deadline_ns: int | None = None) -> bool:
        """Wait like :meth:`Task.park`, but in real time.

        The method may return early, because not every end of a wait wakes the waiting task, so the caller must check its
        condition. A wake is never lost: the caller checks its condition after this method has cleared the flag.
        """
        self._clock.ring()
        wait_s = LOOK_EVERY_S
        if deadline_ns is not None:
            wait_s = min(wait_s, (deadline_ns - self._clock.now_ns()) / 1e9)
        if not self._woken and wait_s > 0:
            self._bell.wait(wait_s)
        self._bell.clear()
        now = self._clock.now_ns()
        if not self._woken and deadline_ns is not None and now >= deadline_ns:
            return False
        self._woken = False
        self.attend()
        return True

    def wake(self) -> None:
        """Make the thread check its condition again."""
        self._woken = True
        self._bell.set()

    def run_next_first(self) -> None:
        """Do nothing, because only the main thread runs items of the agenda."""


def start_real_thread(body: Callable[[], object], name: str) -> Task:
    """Run `body` in a new real thread, and return the task of the thread."""
    begun = threading.Event()
    tasks: list[Task] = []

    def run() -> None:
        tasks.append(current_task())
        begun.set()
        try:
            body()
        except TaskKilled:
            pass
        finally:
            tasks[0].finished = True

    threading.Thread(target=run, name=name, daemon=True).start()
    begun.wait()
    return tasks[0]
