"""`threading` and `queue` in simulated time. A thread is a task of the process that creates it."""

from __future__ import annotations

import queue
import threading as real
from collections.abc import Callable, Iterable, Mapping
from types import ModuleType
from typing import TYPE_CHECKING, Any

from edulaunch.engine.processes.module_views import copy_names
from edulaunch.engine.processes.watchdog import RunawayProgram
from edulaunch.engine.sim import sync
from edulaunch.engine.sim.task import Task, TaskKilled, current_task

if TYPE_CHECKING:
    from edulaunch.engine.processes.process import Process


class Threads:
    """The threads of one process, with their tasks and numbers."""

    def __init__(self, process: Process) -> None:
        self.process = process
        self.by_task: dict[Task, Thread] = {}
        self.count = 0
        self.main = MainThread(name='MainThread', daemon=False, _threads=self)
        self.main._begin(process.lifecycle.task)

    def next_number(self) -> int:
        """Return the next number for names such as Thread-1."""
        self.count += 1
        return self.count

    def current(self) -> Thread:
        """Return the thread whose code is running."""
        return self.by_task.get(current_task(), self.main)

    def alive(self) -> list[Thread]:
        """Return the threads that have started and not ended."""
        return [thread for thread in self.by_task.values() if thread.is_alive()]


def make_threading(view: ModuleType, process: Process) -> ModuleType:
    """Make a `threading` with threads, locks, conditions, events, timers and thread-local data of this process."""
    threads = process.state['threads'] = Threads(process)
    current = threads.current
    view.__dict__.update(
        Thread=Thread,
        Timer=Timer,
        Lock=sync.Lock,
        RLock=sync.RLock,
        Condition=sync.Condition,
        Event=sync.Event,
        Semaphore=sync.Semaphore,
        BoundedSemaphore=sync.BoundedSemaphore,
        Barrier=Barrier,
        local=local,
        excepthook=_print_exception,
        __excepthook__=_print_exception,
        current_thread=current,
        currentThread=current,
        main_thread=lambda: threads.main,
        get_ident=lambda: current().ident,
        get_native_id=lambda: current().ident,
        enumerate=threads.alive,
        active_count=lambda: len(threads.alive()),
        activeCount=lambda: len(threads.alive()),
        _register_atexit=lambda function, *arguments, **options: process.lifecycle.before_join.append(
            lambda: function(*arguments, **options)
        ),
    )
    copy_names(view, real)
    return view


def _threads_here() -> Threads:
    threads: Threads = current_task().owner.state['threads']
    return threads


class Thread:
    """The simulated `threading.Thread`: a task of the process that creates it."""

    def __init__(
        self,
        group: None = None,
        target: Callable[..., object] | None = None,
        name: str | None = None,
        args: Iterable[Any] = (),
        kwargs: Mapping[str, Any] | None = None,
        *,
        daemon: bool | None = None,
        context: Any = None,
        _threads: Threads | None = None,
    ) -> None:
        threads = self._threads = _threads or _threads_here()
        self._target, self._args, self._kwargs = target, args, kwargs or {}
        suffix = f' ({target.__name__})' if target is not None and hasattr(target, '__name__') else ''
        self.name = name if name is not None else f'Thread-{threads.next_number()}{suffix}'
        self.daemon: bool = threads.current().daemon if daemon is None else bool(daemon)
        self._task: Task | None = None
        self._started = False
        self.ident: int | None = None

    def __repr__(self) -> str:
        state = 'started' if self.is_alive() else 'stopped' if self._started else 'initial'
        words = [state, *(['daemon'] if self.daemon else []), *([] if self.ident is None else [str(self.ident)])]
        return f'<{type(self).__name__.replace("MainThread", "_MainThread")}({self.name}, {" ".join(words)})>'

    @property
    def native_id(self) -> int | None:
        """The same number as `ident`."""
        return self.ident

    def start(self) -> None:
        """Run the thread up to its first wait, as CPython nearly always does. Then the caller continues."""
        if self._started:
            raise RuntimeError('threads can only be started once')
        self._started = True
        self._threads.process.start_thread(self._main, self.name, self.daemon, at_once=True)

    def _main(self) -> None:
        self._begin(current_task())
        try:
            self.run()
        except SystemExit:
            return
        except BaseException as error:
            if isinstance(error, (TaskKilled, RunawayProgram)):
                raise
            view: Any = self._threads.process.loader.modules['threading']
            view.excepthook(real.ExceptHookArgs((type(error), error, error.__traceback__, self)))

    def _begin(self, task: Task) -> None:
        """Set the task that runs this thread."""
        self._task, self._started = task, True
        self.ident = self._threads.process.pid * 1000 + len(self._threads.by_task)
        self._threads.by_task[task] = self

    def run(self) -> None:
        """Call the target of the thread, if there is one."""
        if self._target is not None:
            self._target(*self._args, **self._kwargs)

    def join(self, timeout: float | None = None) -> None:
        """Wait until the thread has ended, but at most `timeout` simulated seconds (None: no limit)."""
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
        """Return whether the thread has started and not ended."""
        return self._started and self._task is not None and not self._task.finished

    def isDaemon(self) -> bool:
        """Return `daemon`. This is the old name of the attribute."""
        return self.daemon

    def setDaemon(self, daemonic: bool) -> None:
        """Set `daemon`. This is the old way to set the attribute."""
        self.daemon = daemonic

    def getName(self) -> str:
        """Return `name`. This is the old way to read the attribute."""
        return self.name

    def setName(self, name: str) -> None:
        """Set `name`. This is the old way to set the attribute."""
        self.name = name


class MainThread(Thread):
    """The thread that runs the main function of the program."""


class Timer(Thread):
    """The simulated `threading.Timer`."""

    def __init__(
        self,
        interval: float,
        function: Callable[..., object],
        args: Iterable[Any] | None = None,
        kwargs: Mapping[str, Any] | None = None,
    ) -> None:
        super().__init__()
        self.interval, self.function = interval, function
        self.args, self.kwargs = args or (), kwargs or {}
        self.finished = sync.Event()

    def cancel(self) -> None:
        """Cancel the call of the function."""
        self.finished.set()

    def run(self) -> None:
        """Wait for the interval, and then call the function, unless the timer has been cancelled."""
        if not self.finished.wait(self.interval):
            self.function(*self.args, **self.kwargs)
        self.finished.set()


class Barrier(real.Barrier):
    """The simulated `threading.Barrier`: Python's own class, with waits in simulated time."""

    def __init__(self, parties: int, action: Callable[[], object] | None = None, timeout: float | None = None) -> None:
        super().__init__(parties, action, timeout)  # type: ignore[arg-type]
        self._cond = sync.Condition(sync.Lock())


class local:
    """The simulated `threading.local`. Each thread has its own values, and `__init__` of a subclass is called again for each
    thread.
    """

    def __new__(cls, *arguments: Any, **options: Any) -> local:
        made = super().__new__(cls)
        object.__setattr__(made, '_edulaunch_values', {_threads_here().current(): {}})
        object.__setattr__(made, '_edulaunch_arguments', (arguments, options))
        return made

    def __init__(self, *_: Any, **__: Any) -> None:
        """Do nothing, because a new object has no values."""

    def __getattribute__(self, name: str) -> Any:
        if name == '__dict__':
            return _values(self)
        mine = _values(self)
        return mine[name] if name in mine else object.__getattribute__(self, name)

    def __setattr__(self, name: str, value: Any) -> None:
        _values(self)[name] = value

    def __delattr__(self, name: str) -> None:
        if _values(self).pop(name, self) is self:
            raise AttributeError(f'{type(self).__name__!r} object has no attribute {name!r}')

    def __getattr__(self, name: str) -> Any:
        raise AttributeError(f'{type(self).__name__!r} object has no attribute {name!r}')


def _values(data: local) -> dict[str, Any]:
    """Return the values of the running thread. On first use in a thread, create them."""
    values: dict[Any, dict[str, Any]] = object.__getattribute__(data, '_edulaunch_values')
    thread = _threads_here().current()
    if thread not in values:
        values[thread] = {}
        arguments, options = object.__getattribute__(data, '_edulaunch_arguments')
        type(data).__init__(data, *arguments, **options)
    return values[thread]


def _print_exception(args: Any, /) -> None:
    """Print an error like `threading.excepthook`, but show only frames of the program in the traceback."""
    from edulaunch.engine.processes.traceback_text import student_traceback

    if args.exc_type is not SystemExit:
        process = current_task().owner
        process.write('stderr', f'Exception in thread {args.thread.name}:\n{student_traceback(args.exc_value)[0]}')


class _SimulatedWaiting:
    """The base of the queue classes: Python's own logic, with simulated locks and conditions."""

    def __init__(self, maxsize: int = 0) -> None:
        self.maxsize = maxsize
        self._init(maxsize)  # type: ignore[attr-defined]
        self.mutex = sync.Lock()
        self.not_empty = sync.Condition(self.mutex)
        self.not_full = sync.Condition(self.mutex)
        self.all_tasks_done = sync.Condition(self.mutex)
        self.unfinished_tasks = 0
        self.is_shutdown = False

    def put(self, item: Any, block: bool = True, timeout: float | None = None) -> None:
        """Add an item like `queue.Queue.put`; `timeout` is in simulated seconds."""
        with self.not_full:
            if self.maxsize > 0 and not self._wait(self.not_full, lambda: self._qsize() < self.maxsize, block, timeout):  # type: ignore[attr-defined]
                raise queue.Full
            self._put(item)  # type: ignore[attr-defined]
            self.unfinished_tasks += 1
            self.not_empty.notify()

    def get(self, block: bool = True, timeout: float | None = None) -> Any:
        """Remove and return an item like `queue.Queue.get`; `timeout` is in simulated seconds."""
        with self.not_empty:
            if not self._wait(self.not_empty, lambda: self._qsize() > 0, block, timeout):  # type: ignore[attr-defined]
                raise queue.Empty
            item = self._get()  # type: ignore[attr-defined]
            self.not_full.notify()
            return item

    @staticmethod
    def _wait(condition: sync.Condition, ready: Any, block: bool, timeout: float | None) -> bool:
        if block and timeout is not None and timeout < 0:
            raise ValueError("'timeout' must be a non-negative number")
        return bool(ready() if not block else condition.wait_for(ready, timeout))


class Queue(_SimulatedWaiting, queue.Queue):  # type: ignore[type-arg, misc]
    """The simulated `queue.Queue`, which waits in simulated time."""


class LifoQueue(_SimulatedWaiting, queue.LifoQueue):  # type: ignore[type-arg, misc]
    """The simulated `queue.LifoQueue`, which waits in simulated time."""


class PriorityQueue(_SimulatedWaiting, queue.PriorityQueue):  # type: ignore[type-arg, misc]
    """The simulated `queue.PriorityQueue`, which waits in simulated time."""


def make_queue(view: ModuleType, process: Process) -> ModuleType:
    """Make all queue classes wait in simulated time; `SimpleQueue` is a `Queue` without a limit."""
    view.__dict__.update(Queue=Queue, LifoQueue=LifoQueue, PriorityQueue=PriorityQueue, SimpleQueue=Queue)
    copy_names(view, queue)
    return view
