"""The process that hosts a shared machine, from its start to its end.

Ctrl-C also reaches a program that does not yield. While such a program runs, the machine does not read from terminals, so the
operating system sends the machine a signal when input arrives.
"""

from __future__ import annotations

import gc
import math
import os
import signal
import socket
import sys
import time
from importlib import import_module
from types import FrameType

from edulaunch.desk.machine.heartbeat import Heartbeat
from edulaunch.desk.machine.live import LiveMachine
from edulaunch.desk.machine.place import LISTENER, Address, locked, read_address, remove_address, seconds_from
from edulaunch.desk.machine.server import LOOK_EVERY_S, Server
from edulaunch.engine.processes.streams import streams_of_programs
from edulaunch.runtime.session import Session

PATIENCE_S = 0.3
"""A user who has pressed a key waits at most this many real seconds for a program that does not yield."""
GRACE_S = 10.0
"""A machine waits this many seconds for another terminal after the last one has closed."""
QUIET_S = 0.04
KEPT_S = 120.0
"""A machine that runs for hours keeps messages for this many simulated seconds."""
TURN_LIMIT_S = 2.0
"""The seconds that a program may run without yielding, as in a Session. The other terminals wait during this time."""
EARLY = ('rclpy', 'launch', 'launch_ros.actions')
"""Modules that most commands need; they are loaded while the machine is idle."""


def wake_by_signal(connection: socket.socket) -> None:
    """Make the operating system send SIGIO to this process when input arrives over a connection."""
    if hasattr(signal, 'SIGIO'):
        import fcntl

        fcntl.fcntl(connection, fcntl.F_SETOWN, os.getpid())
        fcntl.fcntl(connection, fcntl.F_SETFL, fcntl.fcntl(connection, fcntl.F_GETFL) | os.O_ASYNC)


class Impatience:
    """Checks for Ctrl-C while a program runs for a long time. It uses SIGIO and SIGALRM, so it needs a separate process."""

    def __init__(self, server: Server) -> None:
        self._server = server
        self._round = -1

    def begin(self) -> None:
        """Install the signal handlers that check for Ctrl-C."""
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


def serve(server: Server, place: str, number: str, address: Address) -> None:
    """Serve terminals until a user stops the machine, or until the last terminal has been closed for a while.

    :param server: the server.
    :param place: the folder of the machines.
    :param number: the ROS_DOMAIN_ID of the machine.
    :param address: the address of the machine, which is removed at the end.
    """
    early, grace_s = list(EARLY), seconds_from('EDULAUNCH_GRACE_S', GRACE_S)
    while not (server.is_asked_to_end or server.terminals.is_asked_to_end):
        due_s = server.run_due_safely()
        left_s = math.inf if server.has_connections() else server.last_seen_s + grace_s - time.monotonic()
        if left_s <= 0:
            break
        if early and (due_s is None or due_s > QUIET_S):
            left_s = QUIET_S
        begun_s = time.monotonic()
        wait_s = min(left_s, math.inf if due_s is None else due_s, LOOK_EVERY_S)
        server.listen(wait_s)
        if early and time.monotonic() - begun_s >= QUIET_S:
            import_module(early.pop(0))
        server.drop_the_silent()
    with locked(place, number):
        remove_address(place, number, address)
    for terminal in list(server.terminals.open_ones):
        terminal.show('stderr', 'error: the machine was stopped (`edulaunch machine stop`, or a signal)\n')
        terminal.ended(1)
    server.flush()
    server.close()


def started(listener: socket.socket, token: str) -> Server:
    """Return the server of a new machine, which sends heartbeats and handles signals.

    :param listener: the listening socket.
    :param token: the secret that a terminal must send.
    :raises OSError: when this computer has no files or no memory left.
    :raises RuntimeError: when it has no threads left.
    """
    session = Session(start_ns=time.time_ns(), turn_limit_s=seconds_from('EDULAUNCH_TURN_LIMIT_S', TURN_LIMIT_S))
    machine = LiveMachine(keep_s=KEPT_S)
    machine.use(session)
    server = Server(machine, listener, token)
    signal.signal(signal.SIGTERM, lambda signum, frame: setattr(server, 'is_asked_to_end', True))
    server.on_accept = wake_by_signal
    Impatience(server).begin()
    Heartbeat(server).begin()
    return server


def main() -> None:
    """Run a machine.

    The command line is `python -m edulaunch.desk.machine.serving FOLDER DOMAIN`. File descriptor 3 is the listening socket.
    """
    place, number = sys.argv[1:3]
    listener = socket.socket(fileno=LISTENER)
    with locked(place, number):  # the parent process has written the address by then
        address = read_address(place, number)
    if address is None or address.pid != os.getpid():
        return
    for name in ('SIGINT', 'SIGHUP'):
        signal.signal(getattr(signal, name), lambda signum, frame: None)  # not SIG_IGN, which real programs would inherit
    try:
        server = started(listener, address.token)
    except (OSError, RuntimeError) as error:  # no files, memory or threads are left
        sys.exit(f'The machine could not start: {error}')
    gc.freeze()
    with streams_of_programs():
        serve(server, place, number, address)
    server.machine.session.close()


if __name__ == '__main__':
    main()
