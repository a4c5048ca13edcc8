"""Waiting in simulated time: `time.sleep` and the locks of `threading` inside a simulation."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable
from typing import Any

from edulaunch.engine.sim.task import Task, current_task


def sleep(seconds: float) -> None:
    """Wait in simulated time, as `time.sleep` does in real time; other programs continue.

    :param seconds: simulated seconds.
    :raises ValueError: if `seconds` is negative.
    """
    if seconds < 0:
        raise ValueError('sleep length must be non-negative')
    task = current_task()
    task.sleep_until(task.sim.now_ns + round(seconds * 1e9))


def _deadline(task: Task, timeout: float | None) -> int | None:
    return None if timeout is None or timeout < 0 else task.sim.now_ns + round(timeout * 1e9)


def wait_until(ready: Callable[[], bool], waiters: deque[Task], timeout: float | None) -> bool:
    """Park the running task in `waiters` until `ready()` is true, or for `timeout` simulated seconds.

    :param timeout: simulated seconds; None or a negative number means no limit.
    :returns: False if the timeout came first, otherwise True.
    """
    task = current_task()
    deadline = _deadline(task, timeout)
    while not ready():
        if deadline is not None and task.sim.now_ns >= deadline:
            return False
        waiters.append(task)
        try:
            task.park(deadline)
        finally:
            if task in waiters:
                waiters.remove(task)
    return True


class Lock:
    """The simulated `threading.Lock`. Waiting tasks acquire it in the order of their requests."""

    def __init__(self) -> None:
        self._held = False
        self._waiters: deque[Task] = deque()

    def acquire(self, blocking: bool = True, timeout: float = -1) -> bool:
        """Acquire the lock, and return whether this succeeded.

        :param blocking: whether to wait for the lock.
        :param timeout: simulated seconds; a negative number means no limit.
        """
        if self._held and not (blocking and wait_until(lambda: not self._held, self._waiters, timeout)):
            return False
        self._held = True
        return True

    def release(self) -> None:
        """Release the lock.

        :raises RuntimeError: if the lock is not held.
        """
        if not self._held:
            raise RuntimeError('release unlocked lock')
        self._held = False
        if self._waiters:
            self._waiters[0].wake()

    def locked(self) -> bool:
        """Return whether the lock is held."""
        return self._held

    def __enter__(self) -> bool:
        return self.acquire()

    def __exit__(self, *_: object) -> None:
        self.release()


class RLock:
    """The simulated `threading.RLock`; the task that holds it may acquire it again."""

    def __init__(self) -> None:
        self._lock = Lock()
        self._owner: Task | None = None
        self._count = 0

    def acquire(self, blocking: bool = True, timeout: float = -1) -> bool:
        """Acquire the lock, possibly again, and return whether this succeeded.

        :param blocking: whether to wait for the lock.
        :param timeout: simulated seconds; a negative number means no limit.
        """
        task = current_task()
        if self._owner is not task:
            if not self._lock.acquire(blocking, timeout):
                return False
            self._owner = task
        self._count += 1
        return True

    def release(self) -> None:
        """Undo one call of `acquire`.

        :raises RuntimeError: if the running task does not hold the lock.
        """
        if self._owner is not current_task():
            raise RuntimeError('cannot release un-acquired lock')
        self._count -= 1
        if not self._count:
            self._owner = None
            self._lock.release()

    def _is_owned(self) -> bool:
        return self._owner is current_task()

    def __enter__(self) -> bool:
        return self.acquire()

    def __exit__(self, *_: object) -> None:
        self.release()


class Condition:
    """The simulated `threading.Condition`."""

    def __init__(self, lock: Lock | RLock | None = None) -> None:
        self._lock: Any = lock if lock is not None else RLock()
        self.acquire = self._lock.acquire
        self.release = self._lock.release
        self._waiting: list[list[bool]] = []
        self._tasks: deque[Task] = deque()

    def __enter__(self) -> bool:
        return bool(self._lock.__enter__())

    def __exit__(self, *_: object) -> None:
        self._lock.release()

    def wait(self, timeout: float | None = None) -> bool:
        """Release the lock, wait for a notification, and acquire the lock again. Return False if the timeout came first.

        :param timeout: simulated seconds; None or a negative number means no limit.
        """
        is_notified = [False]
        self._waiting.append(is_notified)
        depth = self._release_fully()
        try:
            return wait_until(lambda: is_notified[0], self._tasks, timeout)
        finally:
            if is_notified in self._waiting:
                self._waiting.remove(is_notified)
            for _ in range(depth):
                self._lock.acquire()

    def _release_fully(self) -> int:
        depth = self._lock._count if isinstance(self._lock, RLock) else 1
        for _ in range(depth):
            self._lock.release()
        return depth

    def wait_for(self, predicate: Callable[[], Any], timeout: float | None = None) -> Any:
        """Wait until `predicate()` is true, and return its last value.

        :param timeout: simulated seconds; None or a negative number means no limit.
        """
        task = current_task()
        deadline = _deadline(task, timeout)
        result = predicate()
        while not result:
            left = None if deadline is None else (deadline - task.sim.now_ns) / 1e9
            if left is not None and left <= 0:
                break
            self.wait(left)
            result = predicate()
        return result

    def notify(self, n: int = 1) -> None:
        """Wake the `n` tasks that have waited longest."""
        for is_notified in self._waiting[:n]:
            is_notified[0] = True
        del self._waiting[:n]
        for task in self._tasks:
            task.wake()

    def notify_all(self) -> None:
        """Wake all waiting tasks."""
        self.notify(len(self._waiting))


class Event:
    """The simulated `threading.Event`."""

    def __init__(self) -> None:
        self._flag = False
        self._waiters: deque[Task] = deque()

    def is_set(self) -> bool:
        """Return whether the event is set."""
        return self._flag

    def set(self) -> None:
        """Set the event, and wake all waiting tasks."""
        self._flag = True
        for task in self._waiters:
            task.wake()

    def clear(self) -> None:
        """Reset the event."""
        self._flag = False

    def wait(self, timeout: float | None = None) -> bool:
        """Wait until the event is set. Return False if the timeout came first."""
        return wait_until(lambda: self._flag, self._waiters, timeout)


class Semaphore:
    """The simulated `threading.Semaphore`."""

    def __init__(self, value: int = 1) -> None:
        if value < 0:
            raise ValueError('semaphore initial value must be >= 0')
        self._value = value
        self._waiters: deque[Task] = deque()

    def acquire(self, blocking: bool = True, timeout: float | None = None) -> bool:
        """Decrease the counter, and return whether this succeeded. If the counter is zero and `blocking` is true, wait first."""
        if not self._value and not (blocking and wait_until(lambda: self._value > 0, self._waiters, timeout)):
            return False
        self._value -= 1
        return True

    def release(self, n: int = 1) -> None:
        """Increase the counter by `n`."""
        self._value += n
        for task in list(self._waiters)[:n]:
            task.wake()

    def __enter__(self) -> bool:
        return self.acquire()

    def __exit__(self, *_: object) -> None:
        self.release()


class BoundedSemaphore(Semaphore):
    """The simulated `threading.BoundedSemaphore`; its counter cannot exceed its initial value."""

    def __init__(self, value: int = 1) -> None:
        super().__init__(value)
        self._limit = value

    def release(self, n: int = 1) -> None:
        """Increase the counter by `n`.

        :raises ValueError: if the counter would exceed its initial value.
        """
        if self._value + n > self._limit:
            raise ValueError('Semaphore released too many times')
        super().release(n)
