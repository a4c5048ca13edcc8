"""The event handler `OnProcessStart`."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from ..events.process.process_started import ProcessStarted
from .on_action_event_base import OnActionEventBase

if TYPE_CHECKING:
    from .on_action_event_base import ActionMatcher, Reaction


class OnProcessStart(OnActionEventBase):
    """Handles the start of a process.

    :param target_action: the `ExecuteProcess` or `Node`, a callable that decides whether an action matches, or None for every
        process.
    :param on_start: one or more entities, or a callable (event, context) that may return entities.
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
