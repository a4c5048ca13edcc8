"""The executor that handles events in order of arrival."""

from __future__ import annotations

from rclpy.executors import SingleThreadedExecutor
from rclpy.impl.entity import Entity
from rclpy.task import Task


class EventsExecutor(SingleThreadedExecutor):
    """An executor that first runs tasks, oldest first, then the events of each node in order of arrival, then due timers.

    Other executors sort ready entities by kind and age. Everything else is as in `SingleThreadedExecutor`.
    """

    __module__ = 'rclpy.experimental.events_executor'

    def _collect(self) -> list[Entity]:
        arrivals = [entity for ready_list in self._lists for entity in ready_list.entities]
        batch = super()._collect()
        if len(batch) > 1:
            batch.sort(key=lambda entity: arrivals.index(entity) if entity in arrivals else len(arrivals))
        return batch

    def _tasks_to_run(self) -> list[Task]:
        return super()._tasks_to_run()[::-1]
