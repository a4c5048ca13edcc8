"""Ctrl-C for a program that keeps its turn: nobody listens to terminals then, so the system has to say that one has spoken."""

from __future__ import annotations

import os
import signal
import socket
from types import FrameType
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from edulaunch.machine.server import Server

PATIENCE_S = 0.3
"""Real seconds after which a turn is too long for somebody who has pressed a key."""


def wake_by_signal(connection: socket.socket) -> None:
    """Let SIGIO come whenever something comes over a connection."""
    if hasattr(signal, 'SIGIO'):
        import fcntl

        fcntl.fcntl(connection, fcntl.F_SETOWN, os.getpid())
        fcntl.fcntl(connection, fcntl.F_SETFL, fcntl.fcntl(connection, fcntl.F_GETFL) | os.O_ASYNC)


class Impatience:
    """Looks for Ctrl-C in the midst of a turn that is too long. Only in a process of its own: it takes SIGIO and SIGALRM."""

    def __init__(self, server: Server) -> None:
        self._server = server
        self._round = -1

    def begin(self) -> None:
        """From now on look."""
        if hasattr(signal, 'SIGIO'):
            signal.signal(signal.SIGIO, self._somebody_spoke)
            signal.signal(signal.SIGALRM, self._too_long)

    def _somebody_spoke(self, signum: int, frame: FrameType | None) -> None:
        if not self._server.is_listening:
            self._round = self._server.rounds
            signal.setitimer(signal.ITIMER_REAL, PATIENCE_S)

    def _too_long(self, signum: int, frame: FrameType | None) -> None:
        if not self._server.is_listening and self._server.rounds == self._round:
            self._server.look_for_signals()
