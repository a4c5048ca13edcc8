"""`OnText` and `OnProcessIO`."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from ..event import Event
from ..events.process.process_io import ProcessIO
from ..launch_description_entity import SomeEntitiesType
from .on_action_event_base import OnActionEventBase

if TYPE_CHECKING:
    from ..launch_context import LaunchContext
    from .on_action_event_base import ActionMatcher


OnText = Callable[[ProcessIO], SomeEntitiesType | None]


class OnProcessIO(OnActionEventBase):
    """Handles input and output of a process. Each event contains the bytes that arrived together.

    :param target_action: the `ExecuteProcess` or `Node`, a callable that decides whether an action matches, or None for every
        process.
    :param on_stdin: a callable for the event of each input; it may return entities.
    :param on_stdout: a callable for the event of each standard output; it may return entities.
    :param on_stderr: a callable for the event of each standard error output; it may return entities.
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
        """A description of the streams that the handler handles."""
        streams = {'on_stdin': self.__on_stdin, 'on_stdout': self.__on_stdout, 'on_stderr': self.__on_stderr}
        return ' '.join(f"{name}: '{reaction}'" for name, reaction in streams.items() if reaction is not None)
