"""The event `SignalProcess`."""

from __future__ import annotations

import signal
from typing import TYPE_CHECKING

from ..._bases import ReadOnly
from ...utilities.type_utils import ensure_argument_type
from .process_targeted_event import ProcessMatcher, ProcessTargetedEvent

if TYPE_CHECKING:
    from edulaunch.engine.processes.spec import Signals


class SignalProcess(ProcessTargetedEvent):
    """Requests a signal to processes.

    :param signal_number: a `signal.Signals`, or the string 'SIGKILL', because some systems do not have that signal.
    :raises TypeError: for a plain number.
    """

    name = 'launch.events.process.SignalProcess'

    def __init__(self, *, signal_number: str | Signals, process_matcher: ProcessMatcher) -> None:
        super().__init__(process_matcher=process_matcher)
        from edulaunch.engine.processes.spec import Signals

        kinds = dict.fromkeys((str, signal.Signals, Signals))  # on Windows, the simulated machine has more signals than Python
        ensure_argument_type(signal_number, tuple(kinds), 'signal_number', 'SignalProcess')
        self.__signal = signal_number

    signal: ReadOnly[str | Signals] = ReadOnly("The signal, or 'SIGKILL'.")

    @property
    def signal_name(self) -> str:
        """The name of the signal."""
        return self.__signal if isinstance(self.__signal, str) else self.__signal.name
