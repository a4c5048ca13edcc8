"""The action `Shutdown`."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from ..events.process.process_exited import ProcessExited
from ..events.shutdown import Shutdown as ShutdownEvent
from ..substitution import SomeSubstitutionsType
from ..utilities.texts import normalize_to_list_of_substitutions, perform_substitutions, plain_text
from .emit_event import EmitEvent

if TYPE_CHECKING:
    from ..launch_context import LaunchContext


class Shutdown(EmitEvent):
    """End the whole launch. With `on_exit=Shutdown()`, the end of a process ends the launch.

    :param reason: the reason shown in the log; a string or substitutions.
    """

    def __init__(self, *, reason: SomeSubstitutionsType = 'reason not given', **kwargs: Any) -> None:
        text = plain_text(reason)
        super().__init__(event=ShutdownEvent() if text is None else ShutdownEvent(reason=text), **kwargs)
        self.__reason = normalize_to_list_of_substitutions(reason)

    def execute(self, context: LaunchContext) -> None:
        """Emit the shutdown event."""
        event = context.get_locals_as_dict().get('event')
        if isinstance(event, ProcessExited):
            from ..logging import get_logger

            get_logger('launch').info(f'process[{event.process_name}] was required: shutting down launched system')
        context.emit_event_sync(ShutdownEvent(reason=perform_substitutions(context, self.__reason)))
