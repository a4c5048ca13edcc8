"""Executors, which wait until an entity is ready and then call its callback."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable
from threading import Lock
from typing import TYPE_CHECKING, Any
from warnings import warn

from edulaunch.engine.processes.current import current_process
from edulaunch.engine.sim.task import Task as SimTask
from edulaunch.engine.sim.task import current_task
from edulaunch.ros.passed_on import passed_on
from rclpy.impl.entity import Entity
from rclpy.impl.executor import Executor, TimeoutObject
from rclpy.impl.waiting import ConditionReachedException, ExternalShutdownException, Item, ShutdownException, TimeoutException
from rclpy.task import Task, await_or_execute

if TYPE_CHECKING:
    from rclpy.context import Context

__all__ = [
    'ConditionReachedException',
    'Executor',
    'ExternalShutdownException',
    'MultiThreadedExecutor',
    'ShutdownException',
    'SingleThreadedExecutor',
    'TimeoutException',
    'TimeoutObject',
    'await_or_execute',
]

DEFAULT_THREADS = 8
"""The default number of threads. It does not depend on the computer, so that a program behaves the same everywhere."""


class SingleThreadedExecutor(Executor):
    """An executor that executes one callback after the other, in the thread that spins."""

    _spins = True


class MultiThreadedExecutor(Executor):
    """An executor with up to `num_threads` threads. While one callback blocks, callbacks of other groups can run.

    The threads are simulated, so no callback is preempted, and the order is the same in every run.
    """

    _spins = True

    def __init__(self, num_threads: int | None = None, *, context: Context | None = None) -> None:
        super().__init__(context=context)
        if num_threads == 1:
            warn('MultiThreadedExecutor is used with a single thread.\nUse the SingleThreadedExecutor instead.', stacklevel=2)
        self._num_threads = DEFAULT_THREADS if num_threads is None else num_threads
        if self._num_threads <= 0:
            raise ValueError('max_workers must be greater than 0')
        self._jobs: deque[Callable[[], None]] = deque()
        self._lock = Lock()
        self._idle: list[SimTask] = []
        self._threads: list[SimTask] = []
        self._running: dict[SimTask, tuple[Entity, int]] = {}
        self._begun = 0
        self._failures: list[Exception] = []
        self._ending: SimTask | None = None

    def _execute(self, item: Item) -> None:
        """Pass an item to a thread, and run the thread until it blocks.

        If the callback raises an exception before it blocks, this method raises it. As in rclpy, an exception after the callback
        has blocked is raised at the next item.
        """
        if isinstance(item, Task):
            self._submit(item)
        elif item.callback_group.beginning_execution(item):
            item.queued = True
            self._submit(lambda: self._run_in_thread(item))
        else:
            self._put_back([item])
        current_task().sleep_until(self._sim.now_ns)
        if self._failures:
            raise self._failures.pop(0)

    def _run_in_thread(self, entity: Entity) -> None:
        thread = current_task()
        self._begun += 1
        self._running[thread] = entity, self._begun
        try:
            self._run_begun(entity)
        finally:
            del self._running[thread]
            self.wake()

    def _submit(self, job: Callable[[], None]) -> None:
        with self._lock:
            self._jobs.append(job)
            idle = self._idle.pop(0) if self._idle else None
        if idle is not None:
            idle.wake()
        elif len(self._threads) < self._num_threads:
            process = current_process()
            if not self._threads:
                process.lifecycle.before_join.append(self._finish)
            self._threads.append(process.start_worker(self._work_off, f'executor-{len(self._threads)}'))

    def _finish(self) -> None:
        """Wait for running callbacks at the end of the program, as Python waits for the threads of its thread pools."""
        self._ending = current_task()
        while len(self._idle) < len(self._threads):
            self._ending.park()

    def _work_off(self) -> None:
        """Execute jobs, and park while the queue of jobs is empty. Each thread of the executor runs this loop.

        If the executor is shut down and the queue is empty, a thread that is woken leaves the list of idle threads.
        """
        thread = current_task()
        while True:
            job = self._take_job(thread)
            if job is not None:
                try:
                    job()
                    if isinstance(job, Task):
                        job.rcl_raise_if_failed()
                except Exception as error:
                    self._failures.append(error)
                continue
            if self._ending is not None:
                self._ending.wake()
            thread.park()
            if self._is_shutdown and not self._jobs:
                with self._lock:
                    self._threads.remove(thread)
                    self._idle = [idle for idle in self._idle if idle is not thread]
                return

    def _take_job(self, thread: SimTask) -> Callable[[], None] | None:
        """Return the next job for a thread. Without a job, return None, and list the thread as idle.

        In a plain script, the threads can be real, so several of them may do this at once.
        """
        with self._lock:
            if not self._jobs:
                if thread not in self._idle:
                    self._idle.append(thread)
                return None
            if thread in self._idle:
                self._idle.remove(thread)
            return self._jobs.popleft()

    def rcl_running_entity(self) -> Entity | None:
        running = self._running.get(current_task())
        return None if running is None else running[0]

    def rcl_cannot_serve(self, entity: Entity) -> tuple[Any, ...] | None:
        turn = self._running.get(current_task())
        if turn is None or turn[0].callback_group is not entity.callback_group or entity.callback_group.can_execute(entity):
            return None
        return turn


__getattr__ = passed_on(__name__)
