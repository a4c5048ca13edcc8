"""A command on the machine for a program instead of a person: no keyboard, and the output goes to a function."""

from __future__ import annotations

import signal
import time
from collections.abc import Callable, Sequence

from edulaunch.machine import wire
from edulaunch.machine.client import hello
from edulaunch.machine.place import UnsafePlace, domain, folder, read_address
from edulaunch.machine.starting import connect


def has_terminals_machine() -> bool:
    """Whether terminals have started a machine in this domain that is running."""
    try:
        address = read_address(folder(), domain())
        found = connect(domain(), start=False) if address is not None and address.host == 'terminals' else None
    except (UnsafePlace, OSError):
        return False
    if found is not None:
        found[0].close()
    return found is not None


def ask(words: Sequence[str], write: Callable[[str, str], object], *, seconds: float | None = None) -> int | None:
    """Run a command on the machine that is running; returns its exit code, None when there is no machine.

    :param write: called as write('stdout' | 'stderr', text).
    :param seconds: real time after which Ctrl-C is pressed.
    """
    found = connect(domain(), start=False)
    if found is None:
        return None
    connection, token = found
    frames = wire.Frames(wire.FROM_MACHINE)
    deadline = None if seconds is None else time.monotonic() + seconds
    with connection:
        connection.sendall(hello(token, words, keyboard=False))
        while True:
            connection.settimeout(None if deadline is None else max(0.001, deadline - time.monotonic()))
            try:
                data = connection.recv(1 << 16)
            except TimeoutError:
                deadline = None
                connection.sendall(wire.frame(wire.SIGNAL, str(int(signal.SIGINT)).encode()))
                continue
            for kind, payload in frames.feed(data):
                if kind in (wire.OUTPUT, wire.ERRORS):
                    write('stdout' if kind == wire.OUTPUT else 'stderr', payload.decode('utf-8', 'replace'))
                elif kind == wire.EXIT:
                    return int(payload)
            if not data:
                return None
