"""The base class of executors, which manages nodes and tasks, executes callbacks and spins."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from edulaunch.engine.facts import with_facts
from edulaunch.engine.processes.current import current_process
from edulaunch.engine.sim.task import current_task
from edulaunch.ros.read_only import ReadOnly
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup, ReentrantCallbackGroup
from rclpy.impl.entity import CLIENT, GUARD, SERVICE, SUBSCRIPTION, TIMER, WAITABLE, Entity
from rclpy.impl.facts import note_sleep
from rclpy.impl.own_names import TO_SPIN, check_own_names
from rclpy.impl.refusals import check_future, check_node, stopped
from rclpy.impl.waiting import ConditionReachedException, Item, ShutdownException, TimeoutException, Waiting, never
from rclpy.node_parts.core import core_of
from rclpy.task import Future, Task
from rclpy.utilities import timeout_sec_to_nsec

if TYPE_CHECKING:
    from rclpy.context import Context
    from rclpy.node import Node


class TimeoutObject:
    """A timeout that the program may shorten while an executor uses it."""

    def __init__(self, timeout: float) -> None:
        self._timeout = timeout

    @property
    def timeout(self) -> float:
        """The timeout in seconds."""
        return self._timeout

    @timeout.setter
    def timeout(self, timeout: float) -> None:
        self._timeout = timeout


class Executor(Waiting):
    """The base class of executors.

    One *wait* collects all ready items: tasks, waitables, then for each node its timers, subscriptions, guard conditions, clients
    and services. The next wait begins when the executor has executed all of them.

    An executor can be used as a context manager, which shuts it down.
    """

    _spins = False
    """Whether this class executes callbacks. The base class does not, and a custom class defines its own `spin_once`."""

    def __init__(self, *, context: Context | None = None) -> None:
        super().__init__(context=context)
        self._nodes: list[Node] = []
        self._nested_recorded = False
        current_process().on_sleep = note_sleep
        self._context.executors.append(self)

    context: ReadOnly[Context] = ReadOnly('The context that ends the executor with it.', '_context')

    def __enter__(self) -> Executor:
        return self

    def __exit__(self, *_: Any) -> None:
        self.shutdown()

    def add_node(self, node: Node) -> bool:
        """Add a node, and remove it from its previous executor. Return False if this executor already has the node."""
        if self._is_shutdown:
            self._check_open()
        try:
            core = core_of(node)
        except AttributeError:
            check_node(node)
            raise
        ready_list = core.ready_list
        if ready_list.executor is self:
            return False
        ready_list.executor, ready_list.waiting = self, self._waiting
        self._nodes.append(node)
        if core.executor is not self:
            node.executor = self
        self._lists.append(ready_list)
        self._nodes_changed()
        if not core.was_spun:  # done once, because `rclpy.spin_once(node)` adds the node each time and would take a fifth longer
            core.was_spun = True
            try:
                check_own_names(node, TO_SPIN)
            except (TypeError, AttributeError) as error:
                self.create_task(_fail, error)  # this wakes the spinning executor
        return True

    def remove_node(self, node: Node) -> None:
        """Stop executing this node's callbacks."""
        if node in self._nodes:
            self._nodes.remove(node)
            ready_list = core_of(node).ready_list
            self._lists.remove(ready_list)
            if ready_list.executor is self:
                ready_list.executor, ready_list.waiting = None, []
            self._nodes_changed()

    def _nodes_changed(self) -> None:
        """Wake the waiting threads, because the list of nodes has changed. A thread that executes a callback checks after the
        callback.
        """
        if self.spinner is not None:
            self._woken = True
        if self._waiting:
            self._look_again()

    def get_nodes(self) -> list[Node]:
        """Return the nodes in the order in which they were added."""
        return list(self._nodes)

    def create_task(self, callback: Any, *args: Any, **kwargs: Any) -> Task:
        """Create a task that runs a function or coroutine on the next turn of the executor."""
        self._check_open()
        task = Task(callback, args, kwargs, executor=self)
        self._tasks.append(task)
        self._new_tasks = True
        self._look_again()
        return task

    def _check_open(self) -> None:
        """Raise rclpy's error if the executor was shut down and accepts no more work."""
        if self._is_shutdown:
            raise with_facts(AttributeError("'NoneType' object has no attribute 'trigger'"), 'programs.ended-executor')

    def shutdown(self, timeout_sec: float | None = None) -> bool:
        """Stop executing callbacks, and end the current wait."""
        self._is_shutdown = True
        self.wake()
        for node in self.get_nodes():
            self.remove_node(node)
        if self in self._context.executors:
            self._context.executors.remove(self)
        return True

    def wait_for_ready_callbacks(
        self,
        timeout_sec: float | TimeoutObject | None = None,
        nodes: list[Node] | None = None,
        condition: Callable[[], bool] = never,
    ) -> tuple[Task, Any, Any]:
        """Return the next (task, entity, node), for custom executors. Calling the task executes it.

        :raises TimeoutException: when nothing is ready in time.
        :raises ShutdownException: when the executor is shut down.
        :raises ConditionReachedException: when `condition()` is true.
        """
        timeout_ns = _nanoseconds(timeout_sec)
        deadline_ns = None if timeout_ns < 0 else self._sim.now_ns + timeout_ns
        item = self._next_item((timeout_ns, condition), deadline_ns, timeout_ns == 0, condition)
        if isinstance(item, Task):
            return item, None, None
        node = next((node for node in self._nodes if core_of(node).ready_list is item.ready_list), None)
        return Task(lambda: self._run_entity(item), executor=self), item, node

    def can_execute(self, entity: Entity) -> bool:
        """Return whether the group of an entity allows its callback to start now."""
        return entity.callback_group.can_execute(entity)

    def _execute(self, item: Item) -> None:
        """Execute one item in the current thread. Raise the exception that its callback raises."""
        if isinstance(item, Task):
            item()
            item.rcl_raise_if_failed()
        else:
            self._run_entity(item)

    def _run_entity(self, entity: Entity) -> None:
        """Execute an entity if its group allows its callback to begin now.

        Nearly all callbacks are plain functions in one of the two common groups. This method repeats the rules of these groups,
        which makes a service round trip 4 % faster.
        """
        group = entity.callback_group
        kind = None if entity.rcl_is_async else group.__class__
        if kind is MutuallyExclusiveCallbackGroup and group.busy_with is None:
            group.busy_with = entity
            try:
                entity.rcl_run_callback(self)
            finally:
                group.busy_with = None
        elif kind is ReentrantCallbackGroup:
            entity.rcl_run_callback(self)
        elif group.beginning_execution(entity):
            self._run_begun(entity)
        else:
            self._put_back([entity])

    def _run_begun(self, entity: Entity) -> None:
        """Execute an entity after its group has allowed it to begin."""
        coroutine = None
        try:
            coroutine = entity.rcl_run_callback(self)
        finally:
            if coroutine is None or not entity.rcl_is_async:
                entity.callback_group.ending_execution(entity)
        if coroutine is not None and entity.rcl_is_async:
            self._run_coroutine(entity, coroutine)

    def _run_coroutine(self, entity: Entity, coroutine: Any) -> None:
        """Run a callback's coroutine up to its first wait. The coroutine then continues as a task, and still belongs to its
        group.
        """

        async def guarded() -> None:
            try:
                await coroutine
            finally:
                entity.callback_group.ending_execution(entity)

        task = Task(guarded, executor=self, entity=entity)
        task()
        if task.rcl_ended:
            task.result()
        else:
            self._tasks.append(task)

    def rcl_note_nested_spin(self) -> bool:
        """Return whether this thread spins the executor inside one of the executor's callbacks. Return True only once per
        callback.
        """
        if self._nested_recorded or self.spinner is not current_task():
            return False
        self._nested_recorded = True
        return True

    def rcl_cannot_serve(self, entity: Entity) -> tuple[Any, ...] | None:
        """Return a value if the executor cannot execute this entity while the running code waits, and otherwise None.

        :returns: a value that stays equal during one callback of the running thread.
        """
        return (self._seen_ns,) if self.spinner is current_task() else None

    def rcl_running_entity(self) -> Entity | None:
        """Return the entity whose callback the running thread executes, or None if the group of the callback does not record
        the entity.
        """
        cores = [core_of(node) for node in self._nodes]
        entities: list[Entity] = [
            entity
            for core in cores
            for kind in (core.timers, core.subscriptions, core.services, core.clients, core.guards, core.waitables)
            for entity in kind
        ]
        return next((entity for entity in entities if entity.callback_group.busy_with is entity), None)

    def spin(self) -> None:
        """Execute callbacks until ROS 2 or the executor is shut down.

        :raises ExternalShutdownException: when ROS 2 is shut down from outside while no callback is running.
        :raises ValueError: when another thread is in `spin()` or in `spin_once()` without a timeout.
        """
        context = self._context
        if type(self).spin_once is Executor.spin_once:
            self._check_spins()
        if type(self).spin_once is Executor.spin_once and type(self)._spin_once_impl is Executor._spin_once_impl:
            self._spin(-1, lambda: not context.alive, (-1, never), once=False)
            return
        while context.alive and not self._is_shutdown:  # an executor that the program created
            self.spin_once()

    def spin_once(self, timeout_sec: float | None = None) -> None:
        """Execute one callback.

        :param timeout_sec: the longest wait in simulated seconds. None or a negative number means no limit, and 0 means no wait.
        """
        self._check_spins()
        self._spin_once_impl(timeout_sec)

    def _check_spins(self) -> None:
        """Raise NotImplementedError if this object is an instance of the base class itself, as rclpy does."""
        if not self._spins:
            raise NotImplementedError

    def _spin_once_impl(
        self, timeout_sec: float | TimeoutObject | None = None, wait_condition: Callable[[], bool] = never
    ) -> None:
        """Execute one callback. `spin_once` and `spin_once_until_future_complete` call this method; custom executors can override
        it.

        :param wait_condition: a function that ends the wait when it returns True.
        """
        timeout_ns = _nanoseconds(timeout_sec)
        if not timeout_ns:
            current_task().poll()
        self._spin(timeout_ns, wait_condition, (timeout_ns, wait_condition), once=True)

    def spin_until_future_complete(self, future: Future, timeout_sec: float | None = None) -> None:
        """Execute callbacks until the future is done, for at most `timeout_sec` seconds."""
        self._check_spins()
        over = self._is_over(future)
        self._spin(timeout_sec_to_nsec(timeout_sec), over, over, once=False)

    def spin_once_until_future_complete(self, future: Future, timeout_sec: float | TimeoutObject | None = None) -> None:
        """Execute one callback. Do not wait any longer when the future is done."""
        self._check_spins()
        self._spin_once_impl(timeout_sec, self._is_over(future))

    def _is_over(self, future: Future) -> Callable[[], bool]:
        """Return a condition that is true when the future is done or the context is shut down. The future wakes this executor."""
        check_future(future)
        future.rcl_wake_when_done(self)
        context = self._context
        return lambda: future.rcl_ended or not context.alive

    def _spin(self, timeout_ns: int, over: Callable[[], bool], key: Any, once: bool) -> None:
        """Execute items of the wait that has this key.

        :param timeout_ns: the longest wait in simulated nanoseconds. A negative number means no limit, and 0 means no wait.
        :param over: a function that ends the loop when it returns True.
        :param once: whether to execute only one item.
        """
        sim, poll = self._sim, timeout_ns == 0
        deadline_ns = None if timeout_ns < 0 else sim.now_ns + timeout_ns
        outer, self.spinner = self.spinner, current_task()
        try:
            while not (over() or self._is_shutdown):
                self._execute(self._next_item(key, deadline_ns, poll, over))
                if once or (deadline_ns is not None and sim.now_ns >= deadline_ns):
                    return
        except (ShutdownException, TimeoutException, ConditionReachedException):
            return
        except StopIteration as stop:
            raise stopped(stop) from stop
        finally:
            self.spinner = outer

    def rcl_spin_ready(self) -> None:
        """Execute all ready items, each entity once, without waiting. The function corresponds to spin_some of rclcpp, and uses
        rclcpp's order.
        """
        self._run_tasks()
        batch = self._collect()
        if batch:
            for entity in sorted(batch, key=_rclcpp_order):
                if not entity.destroyed:
                    self._run_entity(entity)
            self._run_tasks()

    def _run_tasks(self) -> None:
        """Execute the pending tasks, newest first."""
        if self._tasks:
            for task in self._tasks_to_run():
                self._execute(task)
            self._forget_tasks()


_RCLCPP_ORDER = {TIMER: 0, SUBSCRIPTION: 1, SERVICE: 2, CLIENT: 3, GUARD: 4, WAITABLE: 5}


def _fail(error: Exception) -> None:
    raise error


def _rclcpp_order(entity: Entity) -> int:
    return _RCLCPP_ORDER[entity.rcl_category]


def _nanoseconds(timeout_sec: float | TimeoutObject | None) -> int:
    return timeout_sec_to_nsec(timeout_sec.timeout if isinstance(timeout_sec, TimeoutObject) else timeout_sec)
