"""The event handler `OnExecutionComplete`."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from ..events.execution_complete import ExecutionComplete
from .on_action_event_base import OnActionEventBase

if TYPE_CHECKING:
    from .on_action_event_base import ActionMatcher, Reaction


class OnExecutionComplete(OnActionEventBase):
    """Handles the completion of an action: a process has ended, or a timer has fired.

    :param target_action: the action, a callable that decides whether an action matches, or None for every action.
    :param on_completion: one or more entities, or a callable (event, context) that may return entities.
    """

    def __init__(self, *, target_action: ActionMatcher = None, on_completion: Reaction, **kwargs: Any) -> None:
        from ..action import Action

        super().__init__(
            action_matcher=target_action,
            on_event=on_completion,
            target_event_cls=ExecutionComplete,
            target_action_cls=Action,
            **kwargs,
        )
