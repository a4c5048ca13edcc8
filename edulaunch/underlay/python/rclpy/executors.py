"""Executors: they wait until something is ready, and call the callbacks."""
from __future__ import annotations

from collections import deque
from collections.abc import Callable, Generator, Iterable
from operator import attrgetter
from typing import TYPE_CHECKING, Any
from warnings import warn

from edulaunch.sim.task import Task as SimTask
from edulaunch.sim.task import current_task
from rclpy.readiness import NEVER_NS, TIMER, WAITABLE, Entity, ReadyList
from rclpy.task import Future, Task
from rclpy.utilities import get_default_context, timeout_sec_to_nsec

if TYPE_CHECKING:
    from rclpy.context import Context
    from rclpy.node import Node

Item = Any
"""What an executor executes: a Task or an Entity."""

TURNS_BEFORE_TIME_PASSES = 1000
PAUSE_NS = 1_000_000
_order_of = attrgetter('_order')


class TimeoutException(Exception):
    """Nothing was ready in time."""


class ShutdownException(Exception):
    """The executor was shut down while it waited."""


class ExternalShutdownException(Exception):
    """ROS 2 was shut down from outside (a signal, another thread) while an executor waited."""


class ConditionReachedException(Exception):
    """What was waited for happened."""


class TimeoutObject:
    """A timeout that may be shortened while it is used."""

    def __init__(self, timeout: float) -> None:
        self._timeout = timeout

    @property
    def timeout(self) -> float:
        """Seconds."""
        return self._timeout

    @timeout.setter
    def timeout(self, timeout: float) -> None:
        self._timeout = timeout


def _never() -> bool:
    return False


class Executor:
    """Base of executors. One *wait* collects everything that is ready: tasks, waitables, then for each node its timers,
    subscriptions, guard conditions, clients and services; the next wait comes when all of that was executed.

    An executor can be used as a context manager, which shuts it down.
    """

    def __init__(self, *, context: Context | None = None) -> None:
        self._context = context or get_default_context()
        self._sim = current_task().sim
        self._nodes: list[Node] = []
        self._lists: list[ReadyList] = []
        self._tasks: list[Task] = []
        self._new_tasks = False
        self._woken = False
        self._waiting: list[SimTask] = []
        self._is_shutdown = False
        self._work: Generator[Item, None, None] | None = None
        self._work_key: Any = None
        self._turns = 0
        self._seen_ns = 0
        self._context._executors.append(self)

    @property
    def context(self) -> Context:
        """The context that ends the executor with it."""
        return self._context

    def __enter__(self) -> Executor:
        return self

    def __exit__(self, *_: Any) -> None:
        self.shutdown()

    # Nodes and tasks

    def add_node(self, node: Node) -> bool:
        """Execute the callbacks of this node from now on; it leaves the executor it was in. False when it is here already."""
        if self._is_shutdown:
            raise ShutdownException()
        if node in self._nodes:
            return False
        node.executor = self
        if node not in self._nodes:
            self._attach(node)
        return True

    def _attach(self, node: Node) -> None:
        self._nodes.append(node)
        ready_list = node._rclpy.ready_list
        ready_list.executor = self
        self._lists.append(ready_list)
        self.wake()

    def remove_node(self, node: Node) -> None:
        """Execute this node's callbacks no more."""
        if node in self._nodes:
            self._nodes.remove(node)
            ready_list = node._rclpy.ready_list
            self._lists.remove(ready_list)
            if ready_list.executor is self:
                ready_list.executor = None
            self.wake()

    def get_nodes(self) -> list[Node]:
        """The nodes, in the order in which they came."""
        return list(self._nodes)

    def create_task(self, callback: Any, *args: Any, **kwargs: Any) -> Task:
        """Run a function or coroutine in the next turn."""
        task = Task(callback, args, kwargs, executor=self)
        self._tasks.append(task)
        self._new_tasks = True
        for waiting in self._waiting:
            waiting.wake()
        return task

    def wake(self) -> None:
        """Let a wait end, so that it looks again."""
        self._woken = True
        for waiting in self._waiting:
            waiting.wake()

    def shutdown(self, timeout_sec: float | None = None) -> bool:
        """Execute nothing more; a wait ends."""
        self._is_shutdown = True
        self.wake()
        for node in self.get_nodes():
            self.remove_node(node)
        if self in self._context._executors:
            self._context._executors.remove(self)
        return True

    # Waiting

    def _collect(self) -> list[Entity]:
        """The entities that are ready now and may begin, in the order of one wait."""
        now = self._sim.now_ns
        batch: list[Entity] = []
        for ready_list in self._lists:
            start = len(batch)
            for timer in ready_list.timers:
                if timer._due_ns <= now and not timer._queued and timer.callback_group.can_execute(timer):
                    batch.append(timer)
            entities = ready_list.entities
            if entities:
                blocked = [entity for entity in entities if not entity.callback_group.can_execute(entity)]
                batch += entities if not blocked else [entity for entity in entities if entity not in blocked]
                ready_list.entities = blocked
            if len(batch) - start > 1:
                batch[start:] = sorted(batch[start:], key=_order_of)
        if len(self._lists) > 1:
            batch.sort(key=lambda entity: entity.category != WAITABLE)
        return batch

    def _put_back(self, entities: Iterable[Entity]) -> None:
        """Let entities that were collected but not executed stand on their lists again."""
        for entity in entities:
            if entity.category != TIMER and entity._queued:
                entity._ready_list.entities.append(entity)

    def _wait(self, deadline_ns: int | None) -> None:
        """Park until something may be ready, a timer is due, or the deadline.

        :raises ShutdownException: when the executor was shut down meanwhile.
        :raises ExternalShutdownException: when the context was.
        """
        due = NEVER_NS if deadline_ns is None else deadline_ns
        for ready_list in self._lists:
            for timer in ready_list.timers:
                if timer._due_ns < due and timer.callback_group.can_execute(timer):
                    due = timer._due_ns
        if not self._woken:
            task = current_task()
            self._waiting.append(task)
            try:
                task.park(due if due < NEVER_NS else None)
            finally:
                self._waiting.remove(task)
        self._woken = False
        if self._is_shutdown:
            raise ShutdownException()
        if not self._context._ok:
            raise ExternalShutdownException()

    def _let_time_pass(self) -> None:
        """Move simulated time on when callbacks keep each other busy without waiting: a real computer needs time for them."""
        now = self._sim.now_ns
        if now != self._seen_ns:
            self._seen_ns = now
            self._turns = 0
        else:
            self._turns += 1
            if self._turns > TURNS_BEFORE_TIME_PASSES:
                current_task().sleep_until(now + PAUSE_NS)

    def _tasks_to_run(self) -> list[Task]:
        """The tasks that can go on, newest first; those that are done are forgotten."""
        self._new_tasks = False
        self._tasks = [task for task in self._tasks if not task._done]
        return [task for task in reversed(self._tasks) if not task._executing]

    def _ready_items(self, timeout_ns: int, condition: Callable[[], bool]) -> Generator[Item, None, None]:
        """One wait, item by item.

        :raises TimeoutException: after `timeout_ns` (0: at once, when what is ready now has been given out).
        :raises ConditionReachedException: when `condition()` holds.
        """
        deadline = None if timeout_ns < 0 else self._sim.now_ns + timeout_ns
        yielded = False
        while not yielded and not self._is_shutdown and not condition():
            self._let_time_pass()
            for task in self._tasks_to_run():
                yielded = True
                yield task
            batch = self._collect()
            if not batch and not self._new_tasks and timeout_ns:
                self._wait(deadline)
                batch = self._collect()
            elif not self._context._ok:
                raise ExternalShutdownException()
            batch.reverse()
            try:
                while batch:
                    if batch[-1]._destroyed:
                        batch.pop()
                    elif batch[-1].callback_group.can_execute(batch[-1]):
                        yielded = True
                        yield batch.pop()
                    else:
                        self._put_back([batch.pop()])
            finally:
                self._put_back(reversed(batch))
            if deadline is not None and self._sim.now_ns >= deadline and not (yielded and timeout_ns):
                raise TimeoutException()
        if self._is_shutdown:
            raise ShutdownException()
        if condition():
            raise ConditionReachedException()

    def _next_item(self, timeout_ns: int, condition: Callable[[], bool]) -> Item:
        """The next item; what one wait collected is given out over successive calls with the same arguments."""
        key = (timeout_ns, condition)
        while True:
            if self._work is None or self._work_key != key:
                old, self._work_key = self._work, key
                if old is not None and not old.gi_running:
                    old.close()
                self._work = self._ready_items(timeout_ns, condition)
            try:
                return next(self._work)
            except StopIteration:
                self._work = None

    def wait_for_ready_callbacks(self, timeout_sec: float | TimeoutObject | None = None, nodes: list[Node] | None = None,
                                 condition: Callable[[], bool] = _never) -> tuple[Task, Any, Any]:
        """For executors of one's own: the next (task, entity, node); call the task to execute it.

        :raises TimeoutException, ShutdownException, ConditionReachedException: as their names say.
        """
        seconds = timeout_sec.timeout if isinstance(timeout_sec, TimeoutObject) else timeout_sec
        item = self._next_item(timeout_sec_to_nsec(seconds), condition)
        if isinstance(item, Task):
            return item, None, None
        node = next((node for node in self._nodes if node._rclpy.ready_list is item._ready_list), None)
        return Task(lambda: self._run_entity(item), executor=self), item, node

    # Executing

    def _execute(self, item: Item) -> None:
        """Execute one item in place. Raises what its callback raises."""
        if isinstance(item, Task):
            item()
            if item._exception is not None:
                item.result()
        else:
            self._run_entity(item)

    def _run_entity(self, entity: Entity) -> None:
        group = entity.callback_group
        if not group.beginning_execution(entity):
            self._put_back([entity])
            return
        going_on = False
        try:
            result = entity._run(self)
            if result is not None and entity.is_async:
                going_on = self._run_coroutine(entity, result)
        finally:
            if not going_on:
                group.ending_execution(entity)

    def _run_coroutine(self, entity: Entity, coroutine: Any) -> bool:
        """Run a callback's coroutine as far as it goes; True when it goes on as a task, with its group held."""
        task = Task(coroutine, executor=self)
        task()
        if task._done:
            task.result()
            return False
        task._callbacks.append(lambda _: entity.callback_group.ending_execution(entity))
        self._tasks.append(task)
        return True

    def _cannot_serve(self, entity: Entity) -> bool:
        """Whether the code that runs now, by waiting, keeps this entity from ever being executed."""
        return not entity.callback_group.can_execute(entity) or not self._waiting

    # Spinning

    def spin(self) -> None:
        """Execute callbacks until ROS 2 or the executor is shut down."""
        while self._context._ok and not self._is_shutdown:
            self.spin_once()

    def spin_once(self, timeout_sec: float | None = None) -> None:
        """Execute one callback, waiting for it at most `timeout_sec` (None or negative: for ever; 0: not at all)."""
        self._spin_once(timeout_sec_to_nsec(timeout_sec), _never)

    def _spin_once(self, timeout_ns: int, condition: Callable[[], bool]) -> None:
        if not timeout_ns:
            current_task().poll()
        try:
            item = self._next_item(timeout_ns, condition)
        except (ShutdownException, TimeoutException, ConditionReachedException):
            return
        self._execute(item)

    def spin_until_future_complete(self, future: Future, timeout_sec: float | None = None) -> None:
        """Execute callbacks until the future is done, at most for `timeout_sec` seconds."""
        future.add_done_callback(lambda _: self.wake())
        deadline = None if timeout_sec is None or timeout_sec < 0 else self._sim.now_ns + timeout_sec_to_nsec(timeout_sec)

        def over() -> bool:
            return future._done or not self._context._ok

        while self._context._ok and not future._done and not self._is_shutdown:
            left = -1 if deadline is None else deadline - self._sim.now_ns
            self._spin_once(left, over)
            if deadline is not None and self._sim.now_ns >= deadline:
                return

    def spin_once_until_future_complete(self, future: Future, timeout_sec: float | TimeoutObject | None = None) -> None:
        """Execute one callback, unless the future is done before."""
        seconds = timeout_sec.timeout if isinstance(timeout_sec, TimeoutObject) else timeout_sec
        future.add_done_callback(lambda _: self.wake())
        self._spin_once(timeout_sec_to_nsec(seconds), lambda: future._done or not self._context._ok)

    def _spin_some(self) -> None:
        """Execute everything that is ready now, each entity once, without waiting (rclcpp's spin_some)."""
        for task in self._tasks_to_run():
            self._execute(task)
        for entity in self._collect():
            if not entity._destroyed:
                self._execute(entity)


class SingleThreadedExecutor(Executor):
    """Executes one callback after the other, in the thread that spins."""

    def spin(self) -> None:
        """Execute callbacks until ROS 2 or the executor is shut down.

        :raises ExternalShutdownException: when ROS 2 is shut down from outside while nothing is executed.
        :raises ValueError: when another thread waits in this executor already.
        """
        if type(self).spin_once is not Executor.spin_once or self._work is not None:
            super().spin()
            return
        if self._waiting:
            raise ValueError('generator already executing')
        try:
            while self._context._ok and not self._is_shutdown:
                self._turn()
        except ShutdownException:
            return

    def _turn(self) -> None:
        """One wait with all it brings; what :meth:`_ready_items` does, in the fewest steps."""
        self._let_time_pass()
        context = self._context
        if self._tasks:
            for task in self._tasks_to_run():
                self._execute(task)
                if not context._ok:
                    return
        batch = self._collect()
        if not batch:
            if not self._new_tasks:
                self._wait(None)
            return
        position = 0
        try:
            for entity in batch:
                position += 1
                if not entity._destroyed:
                    self._run_entity(entity)
                if not context._ok:
                    return
        finally:
            if position < len(batch):
                self._put_back(batch[position:])


class MultiThreadedExecutor(Executor):
    """Executes callbacks in up to `num_threads` threads: one that blocks lets those of other groups go on.

    Threads are simulated: nothing is preempted, and the order is the same in every run. The default number of threads is
    fixed, not the machine's, so that a program behaves the same everywhere.
    """

    DEFAULT_THREADS = 8

    def __init__(self, num_threads: int | None = None, *, context: Context | None = None) -> None:
        super().__init__(context=context)
        if num_threads is None:
            num_threads = self.DEFAULT_THREADS
        if num_threads == 1:
            warn('MultiThreadedExecutor is used with a single thread.\nUse the SingleThreadedExecutor instead.', stacklevel=2)
        self._num_threads = num_threads
        self._jobs: deque[Callable[[], None]] = deque()
        self._idle: list[SimTask] = []
        self._threads: list[SimTask] = []
        self._failures: list[Exception] = []

    def _execute(self, item: Item) -> None:
        if isinstance(item, Task):
            self._submit(item)
        elif item.callback_group.beginning_execution(item):
            self._submit(lambda: self._run_begun(item))
        else:
            self._put_back([item])
        if self._failures:
            raise self._failures.pop(0)

    def _run_begun(self, entity: Entity) -> None:
        going_on = False
        try:
            result = entity._run(self)
            if result is not None and entity.is_async:
                going_on = self._run_coroutine(entity, result)
        finally:
            if not going_on:
                entity.callback_group.ending_execution(entity)
                self.wake()

    def _submit(self, job: Callable[[], None]) -> None:
        self._jobs.append(job)
        if self._idle:
            self._idle.pop(0).wake()
        elif len(self._threads) < self._num_threads:
            owner = current_task().owner
            self._threads.append(owner.start_thread(self._work_off, f'executor-{len(self._threads)}', True))

    def _work_off(self) -> None:
        """What each thread does: take jobs, park when there are none."""
        thread = current_task()
        while True:
            while self._jobs:
                job = self._jobs.popleft()
                try:
                    job()
                    if isinstance(job, Task) and job._exception is not None:
                        job.result()
                except Exception as error:
                    self._failures.append(error)
            self._idle.append(thread)
            while thread in self._idle:
                thread.park()

    def _cannot_serve(self, entity: Entity) -> bool:
        return not entity.callback_group.can_execute(entity)
