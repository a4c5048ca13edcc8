"""The executor that most programs use."""
from __future__ import annotations

from edulaunch.sim.task import current_task
from rclpy.execution.exceptions import ShutdownException
from rclpy.execution.executor import Executor


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
            raise ValueError('generator already executing')
        self._forget_work()
        outer, self._spinner = self._spinner, current_task()
        try:
            while self._context._ok and not self._is_shutdown:
                self._turn()
        except ShutdownException:
            return
        finally:
            self._spinner = outer

    def _turn(self) -> None:
        """One wait with all it brings: what `spin_once` does in several calls, in the fewest steps."""
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
