"""Programs as tasks: their start, their end, and the running task. `parking.py` handles their waiting.

The code of a plain script is a task, too (`AmbientTask`), which is created when the script first uses ROS.
"""

from __future__ import annotations

import threading
from collections.abc import Callable
from types import FrameType
from typing import Any, Protocol

from greenlet import GreenletExit, getcurrent, greenlet

from edulaunch.engine.sim.parking import Parking
from edulaunch.engine.sim.parking import TaskKilled as TaskKilled
from edulaunch.engine.sim.simulation import Simulation
from edulaunch.engine.underlay_place import help_text
from edulaunch.errors import SimulationError


class Task(Parking):
    """One blocking program in simulated time.

    :param sim: the simulation.
    :param body: the program. `result` stores its return value, and `exception` stores the exception that ended it.
    :param name: the name that messages show.
    :param owner: the owner of the running code (a `Process`). Code can read it from :func:`current_task`.
    """

    def __init__(self, sim: Simulation, body: Callable[[], object], *, name: str = 'task', owner: Any = None) -> None:
        super().__init__(sim)
        self.name = name
        self.owner = owner
        self.finished = False
        self.result: object = None
        self.exception: BaseException | None = None
        self._body = body
        self._done: list[Callable[[Task], object]] = []

    def __repr__(self) -> str:
        return f'<Task {self.name}>'

    @property
    def frame(self) -> FrameType | None:
        """The frame in which the task is parked, or None while the task runs and after its end."""
        return getattr(self._greenlet, 'gr_frame', None)

    is_real_thread = False
    """Whether the task represents a real thread beside the main one; see `real_threads.py`."""

    def start(self) -> None:
        """Schedule the first turn of the task at the current simulated time."""
        starter = running_task()
        if starter is not None and starter.is_real_thread:  # only the main thread creates greenlets and knows the time
            self._soon.append([self.sim.start_ns, 0, 1, lambda: self._make_greenlet()()])
        else:
            self.sim.schedule(self.sim.now_ns, self._make_greenlet())

    def _make_greenlet(self) -> Callable[[], object]:
        self._greenlet = _TaskGreenlet(self._run)
        self._greenlet.task = self
        switch: Callable[[], object] = self._greenlet.switch
        self._turn[3] = switch
        return switch

    def start_at_once(self) -> None:
        """Run the task before everything else that is due at this instant. The calling task continues when the new task first
        waits.
        """
        self._soon.appendleft([self.sim.now_ns, 0, 0, self._make_greenlet()])
        starter = running_task()
        if starter is not None and starter.sim is self.sim:
            starter.run_next_first()

    def run_next_first(self) -> None:
        """Run the first item that is due at this instant, and then continue this task. Wakes in the meantime are not lost."""
        due = self._soon.popleft()
        self._soon.extendleft((self._turn, due))
        if self.loop is None:
            self.sim.hub.switch()
        else:
            self.loop.step_aside(self.sim.hub.switch)

    def _run(self) -> None:
        try:
            self.attend()
            self.result = self._body()
        except TaskKilled:
            pass
        except BaseException as error:
            if isinstance(error, GreenletExit) or not hasattr(self, '_timer'):
                return  # the simulation was deleted together with the task, so nothing can receive a report
            self.exception = error
        self.finished = True
        self._parked = False
        if self._timer is not None:
            self._timer[3] = None
        getcurrent().parent = self.sim.hub
        for callback in self._done:
            callback(self)

    def add_done_callback(self, callback: Callable[[Task], object]) -> None:
        """Call `callback(task)` when the program has ended, or immediately if it has already ended."""
        if self.finished:
            callback(self)
        else:
            self._done.append(callback)


class ThreadsBeside(Protocol):
    """The real threads that take part in the simulation of a plain script's main thread; see `real_threads.py`."""

    def keep_time(self) -> None:
        """Make simulated time equal to real time from now on."""

    def set_the_pace(self, due_ns: int | None) -> bool:
        """Return whether the main thread must wait in real time for an item that is due at `due_ns`. None means that there is
        no item.
        """

    def await_turn(self, due_ns: int | None) -> bool:
        """Return whether the item at `due_ns` is due. If it is not, wait for a moment, and return False."""

    def let_begin(self) -> None:
        """Wait for a moment, in which threads that have just been started can run."""

    def ring(self) -> None:
        """Make the main thread check its condition again immediately."""

    def join(self) -> AmbientTask:
        """Add the running thread to the simulation, and return its task."""


class AmbientTask(Task):
    """The task of code outside any other task, such as a plain script or a notebook cell. Parking it runs the simulation in
    place.
    """

    def __init__(self, sim: Simulation, owner: Any = None) -> None:
        super().__init__(sim, lambda: None, name='main', owner=owner)
        self.real_threads: ThreadsBeside | None = None  # the owner and this attribute are set together
        self._threads = threading.active_count()

    def park(self, deadline_ns: int | None = None) -> bool:
        """Wait like :meth:`Task.park`, and run the simulation meanwhile.

        :raises SimulationError: if no item of the agenda can end the wait.
        """
        sim = self.sim
        while not self._woken:
            next_ns = sim.next_time_ns()
            is_over = deadline_ns is not None and (next_ns is None or next_ns > deadline_ns)
            if next_ns != sim.now_ns and threading.active_count() != self._threads:
                self._threads = threading.active_count()  # some threads have started or ended: let them run before time passes
                if self.real_threads is not None:
                    self.real_threads.let_begin()
                continue
            due_ns = deadline_ns if is_over else next_ns
            beside = self.real_threads
            if beside is not None and beside.set_the_pace(due_ns) and not beside.await_turn(due_ns):
                break
            if is_over:
                sim.now_ns = max(sim.now_ns, deadline_ns or 0)
                return False
            if not sim.step():
                raise SimulationError(
                    'waiting forever: no scheduled event can end this wait', help=help_text('script-waits-forever')
                )
        self._woken = False
        self._deliver_interrupts()
        return True

    def wake(self) -> None:
        """Wake the task like :meth:`Task.wake`. Another thread may call this method, too."""
        super().wake()
        if self.real_threads is not None:
            self.real_threads.ring()

    def run_next_first(self) -> None:
        """Run the next item of the agenda in place."""
        self.sim.step()


class _TaskGreenlet(greenlet):  # type: ignore[misc]
    """A greenlet with an attribute for its task."""

    task: Task


def running_task() -> Task | None:
    """Return the task whose code is running now, or None on the hub and outside any simulation."""
    return getattr(getcurrent(), 'task', None)


def current_task() -> Task:
    """Return the task whose code is running now. Outside any task, return the ambient task of this thread, and create it on
    first use.
    """
    current = getcurrent()
    try:
        task: Task = current.task
    except AttributeError:
        task = current.task = _ambient_task()
    return task


def _ambient_task() -> AmbientTask:
    """Return a new ambient task for this thread.

    If the main thread's task accepts other threads, the new task takes part in the main thread's simulation. Otherwise, it
    has its own simulation.
    """
    host = getattr(_MAIN, 'task', None)
    beside = host.real_threads if isinstance(host, AmbientTask) and host.owner is not None else None
    is_main = beside is None or threading.current_thread() is threading.main_thread()
    return AmbientTask(Simulation()) if is_main or beside is None else beside.join()


def task_around(frame: FrameType | None) -> Task | None:
    """Return the task that a frame of another thread belongs to, or None if there is no such task. The search goes to the
    bottom of the frame's stack.
    """
    while frame is not None:
        if frame.f_code is Task._run.__code__:
            task: Task = frame.f_locals['self']
            return task
        frame = frame.f_back
    return None


def _main_greenlet() -> Any:
    """Return the greenlet of the main thread outside any task, or None if another thread imported this module."""
    if threading.current_thread() is not threading.main_thread():
        return None
    found = getcurrent()
    while found.parent is not None:
        found = found.parent
    return found


_MAIN = _main_greenlet()
