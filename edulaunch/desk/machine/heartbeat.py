"""The machine's side of the pipe to its guardian. It sends two heartbeats a second, and reports the current line on request."""

from __future__ import annotations

import os
import signal
import threading
import time
from types import FrameType
from typing import TYPE_CHECKING

from edulaunch.desk.machine.place import BUSY_SIGN, HEARTBEAT, IDLE_SIGN
from edulaunch.engine.processes.watchdog import RunawayProgram

if TYPE_CHECKING:
    from edulaunch.desk.machine.server import Server

BEAT_S = 0.4


class Heartbeat:
    """Reports whether a machine waits for terminals, or whether a program has not yielded since the last heartbeat.

    :param pipe: the file descriptor of the pipe for the heartbeats. The pipe may have no reader.
    """

    def __init__(self, server: Server, pipe: int = HEARTBEAT) -> None:
        self._server = server
        self._pipe = pipe
        self._rounds = -1

    def begin(self) -> None:
        """Start to send heartbeats, and to handle the guardian's signals."""
        try:
            os.set_blocking(self._pipe, False)
            os.set_inheritable(self._pipe, False)
        except OSError:  # started without a guardian
            return
        if hasattr(signal, 'SIGUSR1'):
            import faulthandler

            faulthandler.register(signal.SIGUSR1, self._pipe, all_threads=False)
            signal.signal(signal.SIGUSR2, self._interrupt)
        threading.Thread(target=self._beat, name='edulaunch heartbeat', daemon=True).start()

    def _beat(self) -> None:
        if hasattr(signal, 'pthread_sigmask'):  # only the main thread should receive these signals, because it runs the programs
            signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGUSR1, signal.SIGUSR2})
        while True:
            rounds = self._server.rounds
            is_idle = self._server.is_listening or rounds != self._rounds
            self._rounds = rounds
            try:
                os.write(self._pipe, (IDLE_SIGN if is_idle else BUSY_SIGN).encode())
            except BrokenPipeError:  # the guardian has ended
                return
            except OSError:  # the pipe is full, or this computer lacks memory
                pass
            time.sleep(BEAT_S)

    def _interrupt(self, signum: int, frame: FrameType | None) -> None:
        """Interrupt the program that runs now, even if it waits or runs C code that checks for signals.

        :raises RunawayProgram: when a program runs now.
        """
        if self._server.machine.session.host.program_here() is not None:
            raise RunawayProgram
