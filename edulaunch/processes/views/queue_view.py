"""`queue` in simulated time."""

from __future__ import annotations

import queue as real
from types import ModuleType
from typing import TYPE_CHECKING, Any

from edulaunch.processes.views import copy_names
from edulaunch.sim import sync

if TYPE_CHECKING:
    from edulaunch.processes.process import Process


class _SimulatedWaiting:
    """Python's own queue classes, with simulated locks and conditions put in; their logic is used as it is."""

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
        """As `queue.Queue.put`."""
        with self.not_full:
            if self.maxsize > 0 and not self._wait(self.not_full, lambda: self._qsize() < self.maxsize, block, timeout):  # type: ignore[attr-defined]
                raise real.Full
            self._put(item)  # type: ignore[attr-defined]
            self.unfinished_tasks += 1
            self.not_empty.notify()

    def get(self, block: bool = True, timeout: float | None = None) -> Any:
        """As `queue.Queue.get`."""
        with self.not_empty:
            if not self._wait(self.not_empty, lambda: self._qsize() > 0, block, timeout):  # type: ignore[attr-defined]
                raise real.Empty
            item = self._get()  # type: ignore[attr-defined]
            self.not_full.notify()
            return item

    @staticmethod
    def _wait(condition: sync.Condition, ready: Any, block: bool, timeout: float | None) -> bool:
        if block and timeout is not None and timeout < 0:
            raise ValueError("'timeout' must be a non-negative number")
        return bool(ready() if not block else condition.wait_for(ready, timeout))


class Queue(_SimulatedWaiting, real.Queue):  # type: ignore[type-arg, misc]
    """As `queue.Queue`, waiting in simulated time."""


class LifoQueue(_SimulatedWaiting, real.LifoQueue):  # type: ignore[type-arg, misc]
    """As `queue.LifoQueue`, waiting in simulated time."""


class PriorityQueue(_SimulatedWaiting, real.PriorityQueue):  # type: ignore[type-arg, misc]
    """As `queue.PriorityQueue`, waiting in simulated time."""


def make(view: ModuleType, process: Process) -> ModuleType:
    """All queue classes wait in simulated time; `SimpleQueue` is a `Queue` without a limit."""
    view.__dict__.update(Queue=Queue, LifoQueue=LifoQueue, PriorityQueue=PriorityQueue, SimpleQueue=Queue)
    copy_names(view, real)
    return view
