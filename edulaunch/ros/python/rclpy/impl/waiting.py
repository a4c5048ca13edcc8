"""The waiting part of an executor, which collects ready entities in order, and parks while no entity is ready."""

from __future__ import annotations

from collections.abc import Callable, Generator, Iterable
from operator import attrgetter
from typing import TYPE_CHECKING, Any

from edulaunch.engine.sim.task import Task as SimTask
from edulaunch.engine.sim.task import current_task
from rclpy.impl.entity import NEVER_NS, TIMER, WAITABLE, Entity, ReadyList
from rclpy.impl.refusals import no_context, two_spinners, without_context
from rclpy.task import Task
from rclpy.utilities import get_default_context

if TYPE_CHECKING:
    from rclpy.context import Context


class TimeoutException(Exception):
    """No entity was ready in time."""

    __module__ = 'rclpy.executors'


class ShutdownException(Exception):
    """The executor was shut down while it waited."""

    __module__ = 'rclpy.executors'


class ExternalShutdownException(Exception):
    """ROS 2 was shut down from outside (a signal, another thread) while an executor waited."""

    __module__ = 'rclpy.executors'


class ConditionReachedException(Exception):
    """The condition of the wait became true."""

    __module__ = 'rclpy.executors'


Item = Any
"""An object that an executor executes: a Task or an Entity."""

TURNS_BEFORE_TIME_PASSES = 200
PAUSE_NS = 1_000_000
_order_of = attrgetter('order')


def never() -> bool:
    """Return False. This function is the condition of a wait that ends only when an entity is ready."""
    return False


def _may_begin(timer: Entity) -> bool:
    return not timer.queued and timer.callback_group.can_execute(timer)


class Waiting:
    """The base class of executors, which collects ready entities and parks.

    :ivar _lists: the ready lists of the executor's nodes, in the order in which the nodes were added.
    :ivar _waiting: the simulated threads that are parked in this executor.
    :ivar spinner: the simulated thread that spins the executor now.
    """

    def __init__(self, *, context: Context | None = None) -> None:
        self._context = context or get_default_context()
        if not self._context.alive:
            raise no_context(self._context)
        self._sim = current_task().sim
        self._lists: list[ReadyList] = []
        self._tasks: list[Task] = []
        self._new_tasks = False
        self._woken = False
        self._waiting: list[SimTask] = []
        self.spinner: SimTask | None = None
        self._is_shutdown = False
        self._work: Any = None  # the current wait, which is a generator
        self._key: Any = None
        self._turns = 0
        self._seen_ns = 0

    def wake(self) -> None:
        """Make the current wait check again. If no thread waits, the next wait checks again immediately."""
        self._woken = True
        if self._waiting:
            self._look_again()

    def _look_again(self) -> None:
        for waiting in tuple(self._waiting):
            waiting.wake()

    def _collect(self) -> list[Entity]:
        """Return the entities that are ready and whose groups allow them to begin, in the order of one wait."""
        now = self._sim.now_ns
        batch: list[Entity] = []
        for ready_list in self._lists:
            start = len(batch)
            if ready_list.due_ns <= now:
                batch += [timer for timer in ready_list.timers if timer.rcl_due_ns <= now and _may_begin(timer)]
            if ready_list.asked:
                batch += [one for one in ready_list.asked if one.rcl_ask() and one.callback_group.can_execute(one)]
            if ready_list.entities:
                waiting, ready_list.entities = ready_list.entities, []
                for entity in waiting:
                    (batch if entity.callback_group.can_execute(entity) else ready_list.entities).append(entity)
            if len(batch) - start > 1:
                batch[start:] = sorted(batch[start:], key=_order_of)
        if len(batch) > 1 and len(self._lists) > 1:
            batch.sort(key=lambda entity: entity.rcl_category != WAITABLE)
        return batch

    @staticmethod
    def _put_back(entities: Iterable[Entity]) -> None:
        """Put entities that were collected but not executed back into their lists."""
        for entity in entities:
            if entity.rcl_category != TIMER and entity.queued and entity not in entity.ready_list.asked:
                entity.ready_list.entities.append(entity)

    def _wait(self, deadline_ns: int | None) -> None:
        """Park until an entity may be ready, a timer is due, or the deadline is reached.

        :raises ShutdownException: when the executor was shut down in the meantime.
        :raises ExternalShutdownException: when the context was shut down in the meantime.
        """
        due = NEVER_NS if deadline_ns is None else deadline_ns
        for ready_list in self._lists:
            if ready_list.due_ns < due:
                for timer in ready_list.timers:
                    if timer.rcl_due_ns < due and _may_begin(timer):
                        due = timer.rcl_due_ns
        task = current_task()
        self._waiting.append(task)  # set before the check, so that a wake from another thread is never lost
        try:
            if not self._woken and self._context.alive and not self._is_shutdown:
                task.park(due if due < NEVER_NS else None)
        finally:
            self._waiting.remove(task)
        self._woken = False
        self._raise_if_over()

    def _raise_if_over(self) -> None:
        if self._is_shutdown:
            raise ShutdownException()
        if not self._context.alive:
            raise ExternalShutdownException()

    def _let_time_pass(self) -> None:
        """Advance simulated time if callbacks trigger each other without a wait, because callbacks take time on a real
        computer.
        """
        now = self._sim.now_ns
        if now != self._seen_ns:
            self._seen_ns = now
            self._turns = 0
        else:
            self._turns += 1
            if self._turns > TURNS_BEFORE_TIME_PASSES:
                current_task().sleep_until(now + PAUSE_NS)

    def _tasks_to_run(self) -> list[Task]:
        """Return the tasks that can continue, newest first."""
        self._new_tasks = False
        return [task for task in reversed(self._tasks) if not (task.rcl_ended or task.executing())]

    def _forget_tasks(self) -> None:
        """Remove finished and cancelled tasks from the list."""
        self._tasks = [task for task in self._tasks if not task.rcl_ended]

    def _ready_items(self, deadline_ns: int | None, poll: bool, condition: Callable[[], bool]) -> Generator[Item, None, None]:
        """Yield the items of one wait, first tasks, then ready entities. Without a deadline, continue with the items of further
        waits.

        With `poll`, do not wait, and yield only the items that are ready now.

        :raises TimeoutException: at `deadline_ns`, or when a poll has yielded all items.
        :raises ConditionReachedException: when `condition()` is true.
        :raises RCLError: when ROS 2 was shut down before the call.
        """
        timed = deadline_ns is not None and not poll
        if not self._context.alive and (timed or not self._is_shutdown):
            raise without_context('failed to create timer' if timed else 'failed to initialize wait set')
        given_out = False
        while not (self._is_shutdown or condition()):
            if given_out and deadline_ns is not None:
                return  # the next call sets its own deadline
            given_out = False
            if self._tasks:
                for task in self._tasks_to_run():
                    given_out = True
                    yield task
                self._forget_tasks()
            batch = self._collect()
            if not (batch or self._new_tasks or poll):
                self._wait(deadline_ns)
                batch = self._collect()
            elif not self._context.alive:
                raise ExternalShutdownException()
            batch.reverse()
            try:
                while batch:
                    entity = batch.pop()
                    if entity.destroyed:
                        continue
                    if entity.callback_group.can_execute(entity):
                        given_out = True
                        yield entity
                    else:
                        self._put_back((entity,))
            finally:
                if batch:
                    self._put_back(reversed(batch))
            if given_out:
                self._let_time_pass()
            if poll or (deadline_ns is not None and not given_out and self._sim.now_ns >= deadline_ns):
                raise TimeoutException()
        if self._is_shutdown:
            raise ShutdownException()
        raise ConditionReachedException()

    def _next_item(self, key: Any, deadline_ns: int | None, poll: bool, condition: Callable[[], bool]) -> Item:
        """Return the next item. Successive calls with the same `key` return the items of one wait.

        :raises ValueError: when another thread waits here with the same key, as rclpy's threads do with equal arguments.
        """
        if self._key != key:
            self.rcl_forget_work()
            self._key = key
        while True:
            if self._work is None:
                self._work = self._ready_items(deadline_ns, poll, condition)
            try:
                return next(self._work)
            except StopIteration:
                self._work = None
            except ValueError as error:
                if not self._work.gi_running:
                    raise
                raise two_spinners(error) from None

    def rcl_forget_work(self) -> None:
        """Drop the remaining items of the current wait. A thread that is waiting with other arguments continues with its
        items.
        """
        work, self._work = self._work, None
        if work is not None and not work.gi_running:
            work.close()
