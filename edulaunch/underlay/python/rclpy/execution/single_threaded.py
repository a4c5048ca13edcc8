"""The executor that most programs use."""

from __future__ import annotations

from edulaunch.sim.task import current_task
from rclpy.constants import S_TO_NS
from rclpy.execution.exceptions import ExternalShutdownException, ShutdownException
from rclpy.execution.executor import Executor
from rclpy.execution.unfit import check_future, stopped
from rclpy.execution.waiting import TURNS_BEFORE_TIME_PASSES
from rclpy.readiness import NEVER_NS, Entity, ReadyList
from rclpy.task import Future


class SingleThreadedExecutor(Executor):
    """Executes one callback after the other, in the thread that spins."""

    __module__ = 'rclpy.executors'

    def spin(self) -> None:
        """Execute callbacks until ROS 2 or the executor is shut down.

        :raises ExternalShutdownException: when ROS 2 is shut down from outside while nothing is executed.
        :raises ValueError: when another thread waits in this executor already.
        """
        if type(self).spin_once is not Executor.spin_once:
            super().spin()
            return
        if self._waiting:
            from rclpy.impl.hints import hinted

            raise hinted(
                ValueError('generator already executing'),
                'another thread spins this executor already; give this one its own: '
                'rclpy.spin(node, rclpy.executors.SingleThreadedExecutor())',
            )
        self._forget_work()
        outer, self._spinner = self._spinner, current_task()
        try:
            while self._context._ok and not self._is_shutdown:
                if len(self._lists) == 1 and not self._tasks:
                    self._spin_node(self._lists[0])
                else:
                    self._turn()
        except ShutdownException:
            return
        except StopIteration as stop:
            raise stopped(stop) from stop
        finally:
            self._spinner = outer

    def spin_until_future_complete(self, future: Future, timeout_sec: float | None = None) -> None:
        """Execute callbacks until the future is done, at most for `timeout_sec` seconds."""
        if timeout_sec == 0 or type(self).spin_once is not Executor.spin_once:
            super().spin_until_future_complete(future, timeout_sec)
            return
        try:
            future._wake_when_done(self)
        except AttributeError:
            check_future(future)
            raise
        deadline = NEVER_NS if timeout_sec is None or timeout_sec < 0 else self._sim.now_ns + int(timeout_sec * S_TO_NS)
        if self._work is not None:
            self._forget_work()
        outer, self._spinner = self._spinner, current_task()
        try:
            while self._context._ok and not future._ended and not self._is_shutdown and self._sim.now_ns < deadline:
                self._turn(future, deadline)
        except ShutdownException:
            return
        except StopIteration as stop:
            raise stopped(stop) from stop
        finally:
            self._spinner = outer

    def _spin_node(self, ready_list: ReadyList) -> None:
        """Do turns while there is one node, one thing ready at a time, and no task: the hot path of most programs.

        Anything else is left to :meth:`_turn`, which would do the same with more steps.
        """
        context, sim, waiting, task = self._context, self._sim, self._waiting, current_task()
        while True:
            entities, due_ns, now = ready_list.entities, ready_list.due_ns, sim.now_ns
            timer_is_due = due_ns <= now
            if not (entities or timer_is_due or self._woken or self._new_tasks):
                waiting.append(task)
                try:
                    task.park(due_ns if due_ns < NEVER_NS else None)
                finally:
                    waiting.remove(task)
                if self._is_shutdown or not context._ok:
                    self._raise_if_over()
                continue
            if now != self._seen_ns:
                self._seen_ns = now
                self._turns = 0
            else:
                self._turns += 1
            if self._woken or self._turns > TURNS_BEFORE_TIME_PASSES:
                break
            if timer_is_due:
                if entities or len(ready_list.timers) != 1:
                    break
                entity: Entity = ready_list.timers[0]
            elif len(entities) == 1:
                entity = entities.pop()
            else:
                break
            self._run_entity(entity)
            if self._tasks:
                self._run_tasks()
            if self._is_shutdown or not context._ok:
                return
        self._turn()

    def _turn(self, until: Future | None = None, deadline_ns: int = NEVER_NS) -> None:
        """One wait with all it brings: what `spin_once` does in several calls. Ends early when `until` is done."""
        self._let_time_pass()
        context = self._context
        if self._tasks:
            self._run_tasks(until)
            if not context._ok or (until is not None and until._ended):
                return
        batch = self._collect()
        if not batch:
            if not self._new_tasks:
                self._wait(deadline_ns)
            elif not context._ok:
                raise ExternalShutdownException()
            return
        position = 0
        try:
            for entity in batch:
                position += 1
                if not entity._destroyed:
                    self._run_entity(entity)
                if not context._ok or (until is not None and until._ended):
                    return
        finally:
            if position < len(batch):
                self._put_back(batch[position:])
