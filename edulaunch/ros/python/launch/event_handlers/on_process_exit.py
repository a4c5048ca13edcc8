"""The event handler `OnProcessExit`."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from ..events.process.process_exited import ProcessExited
from .on_action_event_base import OnActionEventBase

if TYPE_CHECKING:
    from .on_action_event_base import ActionMatcher, Reaction


class OnProcessExit(OnActionEventBase):
    """Handles the end of a process.

    :param target_action: the `ExecuteProcess` or `Node`, a callable that decides whether an action matches, or None for every
        process.
    :param on_exit: one or more entities, or a callable (event, context) that may return entities.
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
