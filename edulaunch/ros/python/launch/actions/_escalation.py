"""Timers that end a process if the first signal does not end it."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from edulaunch.engine.processes.spec import Signals

from ..events.matchers import matches_action
from ..events.process.signal_process import SignalProcess
from ..substitution import Substitution
from ..substitutions.python_expression import PythonExpression
from ..utilities.texts import perform_substitutions
from .emit_event import EmitEvent
from .opaque_function import OpaqueFunction
from .timer_action import TimerAction

if TYPE_CHECKING:
    from ..launch_context import LaunchContext
    from .execute_local import ExecuteLocal

Timeout = list[Substitution]


def escalation_timers(action: ExecuteLocal, logger: Any) -> list[TimerAction]:
    """Return two timers. One sends SIGTERM after `sigterm_timeout` seconds.

    The other timer sends SIGKILL after `sigterm_timeout + sigkill_timeout` seconds.
    """
    kill_after = PythonExpression(['float(', *action.sigterm_timeout, ') + float(', *action.sigkill_timeout, ')'])
    return [
        _timer(action, logger, action.sigterm_timeout, Signals.SIGINT, Signals.SIGTERM),
        _timer(action, logger, [kill_after], Signals.SIGTERM, Signals.SIGKILL),
    ]


def request_signal(action: ExecuteLocal, signum: Signals) -> EmitEvent:
    """Return the action that requests a signal for the process of `action`."""
    return EmitEvent(event=SignalProcess(signal_number=signum, process_matcher=matches_action(action)))


def _timer(action: ExecuteLocal, logger: Any, timeout: Timeout, sent: Signals, next_signal: Signals) -> TimerAction:
    def complain(context: LaunchContext) -> None:
        seconds = perform_substitutions(context, timeout)
        logger.error(
            f"process[{context.locals.process_name}] failed to terminate '{seconds}' seconds after receiving "
            f"'{sent.name}', escalating to '{next_signal.name}'"
        )

    return TimerAction(
        period=timeout, actions=[OpaqueFunction(function=complain), request_signal(action, next_signal)], cancel_on_shutdown=False
    )
