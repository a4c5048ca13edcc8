"""A file of the real machine, such as the terminal, as what a simulated program reads."""

from __future__ import annotations

import os
from codecs import getincrementaldecoder
from typing import TYPE_CHECKING, Any

from edulaunch.processes.inputs import Input
from edulaunch.sim.real_pace import LOOK_EVERY_NS
from edulaunch.sim.task import current_task

if TYPE_CHECKING:
    from edulaunch.processes.host import Host
    from edulaunch.processes.process import Process


class RealInput(Input):
    """An open text file of this machine, such as the terminal. While somebody types, simulated time keeps pace with real time and
    the other programs go on; what is there already is read at once.

    :param file: a terminal, a pipe or a file. One that is no file of the operating system is read line by line.
    :param host: its watchdog is told to be patient while such a file is read.
    """

    def __init__(self, file: Any, host: Host) -> None:
        super().__init__()
        self._file = file
        self._host = host
        self._ended = False
        self._number = _waitable(file)
        self._decoder = getincrementaldecoder('utf-8')('replace')

    def isatty(self) -> bool:
        """Whether it is a terminal."""
        return bool(self._file.isatty())

    def change_mode(self, process: Process, flags: int) -> None:
        """Let the real terminal give each key at once, or whole lines again; its own mode comes back when the program ends.
        Ctrl-C stays what it is.
        """
        import termios

        super().change_mode(process, flags)
        number = self._number
        if number is None or not self.isatty():
            return
        mode = termios.tcgetattr(number)
        if 'terminal' not in process.state:
            process.state['terminal'] = list(mode)
            process.at_exit.append(lambda: termios.tcsetattr(number, termios.TCSADRAIN, process.state['terminal']))
        letters = termios.ICANON | termios.ECHO
        mode[3] = mode[3] & ~letters if self.by_key else mode[3] | letters
        termios.tcsetattr(number, termios.TCSADRAIN, mode)

    def has_ended(self) -> bool:
        """At the end of the file."""
        return self._ended

    def take_due(self) -> None:
        """Add what has been typed."""
        if self._number is not None:
            self._look(0.0)

    def take_more(self, deadline_ns: int | None) -> bool:
        """Wait a moment of real and as much simulated time."""
        if self._number is None:
            return self._read_patiently()
        if self._look(self._host.pace.ahead_s()):
            return True
        task = current_task()
        task.sleep_until(task.sim.now_ns + LOOK_EVERY_NS)
        return False

    def _look(self, seconds: float) -> bool:
        import select

        assert self._number is not None
        if self._ended or not select.select([self._number], [], [], seconds)[0]:
            return self._ended
        chunk = os.read(self._number, 65536)
        self._ended = not chunk
        self._text += self._decoder.decode(chunk, final=self._ended)
        return True

    def _read_patiently(self) -> bool:
        watchdog = self._host.watchdog
        if watchdog is not None:
            watchdog.asleep = True
        try:
            line = self._file.readline()
        finally:
            if watchdog is not None:
                watchdog.asleep = False
        self._text += line
        self._ended = not line
        return True


def _waitable(file: Any) -> int | None:
    """The file's number, when the operating system can tell whether reading it would wait."""
    import select

    try:
        number: int = file.fileno()
        select.select([number], [], [], 0)
    except (AttributeError, OSError, ValueError):
        return None
    return number
