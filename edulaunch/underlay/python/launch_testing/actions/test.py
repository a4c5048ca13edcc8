"""A test program, run as a process."""

from __future__ import annotations

from typing import Any

from launch.actions.emit_event import EmitEvent
from launch.actions.execute_process import ExecuteProcess
from launch.actions.timer_action import TimerAction
from launch.events.matchers import matches_action
from launch.events.process.shutdown_process import ShutdownProcess
from launch.launch_context import LaunchContext
from launch.launch_description_entity import LaunchDescriptionEntity


class Test(ExecuteProcess):
    """A process whose exit code says whether a test passed.

    :param timeout: seconds after which it is asked to end; None: never.
    :param kwargs: those of :class:`launch.actions.ExecuteProcess`.
    """

    __test__ = False  # pytest is not to take this class for a test case

    def __init__(self, *, timeout: float | None = None, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        self.__timeout = timeout
        self.__timer: TimerAction | None = None

    @property
    def timeout(self) -> float | None:
        """Seconds until it is asked to end."""
        return self.__timeout

    def execute(self, context: LaunchContext) -> list[LaunchDescriptionEntity] | None:
        """Start the process, and the timer if there is a timeout."""
        entities = super().execute(context) or []
        if self.__timeout is not None:
            end = EmitEvent(event=ShutdownProcess(process_matcher=matches_action(self)))
            self.__timer = TimerAction(period=float(self.__timeout), actions=[end])
            self.__stop_timer_at_exit(context)
            entities = [*entities, self.__timer]
        return entities or None

    def __stop_timer_at_exit(self, context: LaunchContext) -> None:
        from launch.event_handlers.on_process_exit import OnProcessExit

        def cancel(event: object, context: LaunchContext) -> None:
            assert self.__timer is not None
            self.__timer.cancel()

        context.register_event_handler(OnProcessExit(target_action=self, on_exit=cancel, handle_once=True))
