"""Handlers for the events of processes."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from .._lazy import has_ros_paths
from ..events import Event
from ..events.process import ProcessExited, ProcessIO, ProcessStarted
from ..launch_description_entity import SomeEntitiesType
from .general import OnActionEventBase

if TYPE_CHECKING:
    from ..launch_context import LaunchContext
    from .general import ActionMatcher, Reaction


class OnProcessStart(OnActionEventBase):
    """Reacts when a process has been started.

    :param target_action: the `ExecuteProcess` or `Node`, a callable that decides, or None for every process.
    :param on_start: an entity, several, or a callable (event, context) that may return entities.
    """

    def __init__(self, *, target_action: ActionMatcher = None, on_start: Reaction, **kwargs: Any) -> None:
        from ..actions.execute_process import ExecuteProcess

        super().__init__(
            action_matcher=target_action,
            on_event=on_start,
            target_event_cls=ProcessStarted,
            target_action_cls=ExecuteProcess,
            **kwargs,
        )


OnText = Callable[[ProcessIO], SomeEntitiesType | None]


class OnProcessIO(OnActionEventBase):
    """Reacts to text on the streams of a process, in pieces as they come.

    :param target_action: the `ExecuteProcess` or `Node`, a callable that decides, or None for every process.
    :param on_stdin, on_stdout, on_stderr: each called with the event; may return entities.
    """

    def __init__(
        self,
        *,
        target_action: ActionMatcher = None,
        on_stdin: OnText | None = None,
        on_stdout: OnText | None = None,
        on_stderr: OnText | None = None,
        **kwargs: Any,
    ) -> None:
        from ..actions.execute_local import ExecuteLocal

        self.__on_stdin = on_stdin
        self.__on_stdout = on_stdout
        self.__on_stderr = on_stderr
        super().__init__(
            action_matcher=target_action,
            on_event=self.__on_io,
            target_event_cls=ProcessIO,
            target_action_cls=ExecuteLocal,
            **kwargs,
        )

    def __on_io(self, event: Event, context: LaunchContext) -> SomeEntitiesType | None:
        assert isinstance(event, ProcessIO)
        reaction = self.__on_stderr
        if event.from_stdout:
            reaction = self.__on_stdout
        elif event.from_stdin:
            reaction = self.__on_stdin
        return reaction(event) if reaction is not None else None

    @property
    def handler_description(self) -> str:
        """Which streams are handled."""
        streams = {'on_stdin': self.__on_stdin, 'on_stdout': self.__on_stdout, 'on_stderr': self.__on_stderr}
        return ' '.join(f"{name}: '{reaction}'" for name, reaction in streams.items() if reaction is not None)


class OnProcessExit(OnActionEventBase):
    """Reacts when a process has ended, for whatever reason.

    :param target_action: the `ExecuteProcess` or `Node`, a callable that decides, or None for every process.
    :param on_exit: an entity, several, or a callable (event, context) that may return entities.
    """

    def __init__(self, *, target_action: ActionMatcher = None, on_exit: Reaction, **kwargs: Any) -> None:
        from ..actions.execute_local import ExecuteLocal

        super().__init__(
            action_matcher=target_action,
            on_event=on_exit,
            target_event_cls=ProcessExited,
            target_action_cls=ExecuteLocal,
            **kwargs,
        )


has_ros_paths(__name__)
