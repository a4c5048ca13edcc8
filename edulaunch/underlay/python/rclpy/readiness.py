"""How an executor learns what there is to do: each entity that becomes ready puts itself on its node's list, once."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from rclpy.callback_groups import CallbackGroup
    from rclpy.executors import Executor
    from rclpy.timer import Timer
    from rclpy.waitable import Waitable

WAITABLE, TIMER, SUBSCRIPTION, GUARD, CLIENT, SERVICE = range(6)
"""The order in which the ready entities of one wait are executed (waitables of all nodes before anything else)."""

NEVER_NS = 1 << 63


class ReadyList:
    """What a node's executor looks at: the entities that are ready, and the timers; `due_ns` is when the first of them is due.

    :ivar asked: waitables of the program itself, which are asked in each wait.
    """

    __slots__ = ('entities', 'timers', 'asked', 'executor', 'due_ns')

    def __init__(self) -> None:
        self.entities: list[Entity] = []
        self.timers: list[Timer] = []
        self.asked: list[Waitable] = []
        self.executor: Executor | None = None
        self.due_ns = NEVER_NS

    def plan(self) -> None:
        """Work out `due_ns` again."""
        timers = self.timers
        if len(timers) == 1:
            self.due_ns = timers[0].due_ns
        else:
            self.due_ns = min([timer.due_ns for timer in timers], default=NEVER_NS)

    def notify(self) -> None:
        """Something is ready, or a due time has changed: wake whoever waits."""
        executor = self.executor
        if executor is not None:
            for task in executor._waiting:
                task.wake()


class Entity:
    """Base of what executors run: a callback, its group, and whether something waits for it.

    `_order` sorts the entities of one wait: by category, then by creation. `is_async` tells that running it gives a coroutine.
    """

    category = WAITABLE
    is_async = False

    def __init__(self, ready_list: ReadyList, callback_group: CallbackGroup, number: int) -> None:
        self.callback_group = callback_group
        self.ready_list = ready_list
        self.order = self.category << 32 | number
        self.queued = False
        self._destroyed = False

    def signal(self) -> None:
        """Something came: stand on the ready list and wake the executor."""
        if not self.queued:
            self.queued = True
            ready_list = self.ready_list
            ready_list.entities.append(self)
            executor = ready_list.executor
            if executor is not None:
                for task in executor._waiting:
                    task.wake()

    def _run(self, executor: Executor) -> Any:
        """Take what waits and call the callback with it; it has left the ready list. A coroutine is for the executor to run."""
        raise TypeError(f'{type(self).__name__} cannot be executed')
