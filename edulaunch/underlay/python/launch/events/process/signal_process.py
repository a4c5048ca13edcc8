"""A process is to get a signal."""

from __future__ import annotations

from edulaunch.processes.spec import Signals

from ..._read_only import ReadOnly
from .process_targeted_event import ProcessMatcher, ProcessTargetedEvent


class SignalProcess(ProcessTargetedEvent):
    """Sends a signal to processes.

    :param signal_number: a `signal.Signals`, or its name such as 'SIGUSR1'.
    """

    name = 'launch.events.process.SignalProcess'

    def __init__(self, *, signal_number: str | Signals, process_matcher: ProcessMatcher) -> None:
        super().__init__(process_matcher=process_matcher)
        self.__signal = Signals[signal_number] if isinstance(signal_number, str) else Signals(signal_number)

    signal: ReadOnly[Signals] = ReadOnly('The signal.')

    @property
    def signal_name(self) -> str:
        """Its name."""
        return self.__signal.name
