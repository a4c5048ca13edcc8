"""The event `SignalProcess`."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ..._bases import ReadOnly
from .process_targeted_event import ProcessMatcher, ProcessTargetedEvent

if TYPE_CHECKING:
    from edulaunch.engine.processes.spec import Signals


class SignalProcess(ProcessTargetedEvent):
    """Sends a signal to processes.

    :param signal_number: a `signal.Signals`, or its name such as 'SIGUSR1'.
    """

    name = 'launch.events.process.SignalProcess'

    def __init__(self, *, signal_number: str | Signals, process_matcher: ProcessMatcher) -> None:
        super().__init__(process_matcher=process_matcher)
        from edulaunch.engine.processes.spec import Signals

        self.__signal = Signals[signal_number] if isinstance(signal_number, str) else Signals(signal_number)

    signal: ReadOnly[Signals] = ReadOnly('The signal.')

    signal_name: ReadOnly[str] = ReadOnly('Its name.', '__signal.name')
