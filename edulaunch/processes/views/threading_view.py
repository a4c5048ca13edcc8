"""`threading` in simulated time: a thread is a task of the same process."""
from __future__ import annotations

import threading as real
from collections.abc import Callable, Iterable, Mapping
from types import ModuleType
from typing import TYPE_CHECKING, Any

from edulaunch.processes.views import copy_names
from edulaunch.sim import sync
from edulaunch.sim.task import Task, current_task

if TYPE_CHECKING:
    from edulaunch.processes.process import Process


class Threads:
    """The threads of one process: which task is which thread, and the numbers they get."""

    def __init__(self, process: Process) -> None:
        self.process = process
        self.by_task: dict[Task, Thread] = {}
        self.count = 0
        self.main = Thread(name='MainThread', _threads=self)
        self.main._task, self.main._started = process.task, True
        self.by_task[process.task] = self.main

    def next_number(self) -> int:
        """Thread-1, Thread-2 ..."""
        self.count += 1
        return self.count

    def current(self) -> Thread:
        """The thread whose code runs."""
        return self.by_task.get(current_task(), self.main)

    def alive(self) -> list[Thread]:
        """Those that have begun and not ended."""
        return [thread for thread in self.by_task.values() if thread.is_alive()]


def make(view: ModuleType, process: Process) -> ModuleType:
    """Threads, locks, conditions, events, timers and thread-local data of this process."""
    threads = process.state['threads'] = Threads(process)
    current = threads.current
    view.__dict__.update(
        Thread=Thread, Timer=Timer, Lock=sync.Lock, RLock=sync.RLock, Condition=sync.Condition, Event=sync.Event,
        Semaphore=sync.Semaphore, BoundedSemaphore=sync.BoundedSemaphore, Barrier=sync.Barrier, local=local,
        current_thread=current, currentThread=current, main_thread=lambda: threads.main,
        get_ident=lambda: current().ident, get_native_id=lambda: current().ident,
        enumerate=threads.alive, active_count=lambda: len(threads.alive()), activeCount=lambda: len(threads.alive()),
        _register_atexit=lambda function, *arguments, **options: process.before_join.append(
            lambda: function(*arguments, **options)))
    copy_names(view, real)
    return view


def _threads_here() -> Threads:
    threads: Threads = current_task().owner.state['threads']
    return threads


class Thread:
    """As `threading.Thread`: a task of the process that makes it."""

    def __init__(self, group: None = None, target: Callable[..., object] | None = None, name: str | None = None,
                 args: Iterable[Any] = (), kwargs: Mapping[str, Any] | None = None, *, daemon: bool | None = None,
                 context: Any = None, _threads: Threads | None = None) -> None:
        threads = self._threads = _threads or _threads_here()
        self._target, self._args, self._kwargs = target, args, kwargs or {}
        suffix = f' ({target.__name__})' if target is not None and hasattr(target, '__name__') else ''
        self.name = name if name is not None else f'Thread-{threads.next_number()}{suffix}'
        self.daemon = bool(daemon)
        self._task: Task | None = None
        self._started = False
        self.ident: int | None = threads.process.pid * 1000 + len(threads.by_task)

    def __repr__(self) -> str:
        return f'<Thread({self.name}, {"started" if self.is_alive() else "stopped" if self._started else "initial"})>'

    def start(self) -> None:
        """Give the thread its first turn."""
        if self._started:
            raise RuntimeError('threads can only be started once')
        self._started = True
        self._task = self._threads.process.start_thread(self._main, self.name, self.daemon)
        self._threads.by_task[self._task] = self

    def _main(self) -> None:
        try:
            self.run()
        except (SystemExit, KeyboardInterrupt):
            pass
        except Exception as error:
            from edulaunch.processes.traceback_text import student_traceback
            self._threads.process.write('stderr', f'Exception in thread {self.name}:\n{student_traceback(error)[0]}')

    def run(self) -> None:
        """What the thread does: calls its target."""
        if self._target is not None:
            self._target(*self._args, **self._kwargs)

    def join(self, timeout: float | None = None) -> None:
        """Wait until the thread has ended, or `timeout` simulated seconds."""
        if not self._started or self._task is None:
            raise RuntimeError('cannot join thread before it is started')
        waiting = current_task()
        if waiting is self._task:
            raise RuntimeError('cannot join current thread')
        self._task.add_done_callback(lambda _: waiting.wake())
        sim = waiting.sim
        deadline = None if timeout is None else sim.now_ns + round(max(0.0, timeout) * 1e9)
        while not self._task.finished and (deadline is None or sim.now_ns < deadline):
            waiting.park(deadline)

    def is_alive(self) -> bool:
        """Whether it has begun and not ended."""
        return self._started and self._task is not None and not self._task.finished

    def isDaemon(self) -> bool:
        """Old spelling of `daemon`."""
        return self.daemon

    def setDaemon(self, daemonic: bool) -> None:
        """Old spelling of `daemon = ...`."""
        self.daemon = daemonic

    def getName(self) -> str:
        """Old spelling of `name`."""
        return self.name

    def setName(self, name: str) -> None:
        """Old spelling of `name = ...`."""
        self.name = name


class Timer(Thread):
    """As `threading.Timer`."""

    def __init__(self, interval: float, function: Callable[..., object], args: Iterable[Any] | None = None,
                 kwargs: Mapping[str, Any] | None = None) -> None:
        super().__init__()
        self.interval, self.function = interval, function
        self.args, self.kwargs = args or (), kwargs or {}
        self.finished = sync.Event()

    def cancel(self) -> None:
        """Let it never call."""
        self.finished.set()

    def run(self) -> None:
        """Wait, then call."""
        if not self.finished.wait(self.interval):
            self.function(*self.args, **self.kwargs)
        self.finished.set()


class local:
    """As `threading.local`."""

    def __init__(self) -> None:
        object.__setattr__(self, '_values', {})

    def _mine(self) -> dict[str, Any]:
        values: dict[Any, dict[str, Any]] = object.__getattribute__(self, '_values')
        return values.setdefault(_threads_here().current(), {})

    def __getattr__(self, name: str) -> Any:
        try:
            return self._mine()[name]
        except KeyError:
            raise AttributeError(f"'_thread._local' object has no attribute {name!r}") from None

    def __setattr__(self, name: str, value: Any) -> None:
        self._mine()[name] = value

    def __delattr__(self, name: str) -> None:
        self._mine().pop(name)
