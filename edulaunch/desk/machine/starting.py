"""Functions that find the machine of a terminal's domain or start one. They need only the standard library."""

from __future__ import annotations

import os
import socket
import sys

from edulaunch.desk.machine.place import (
    Address,
    busy_file,
    domain,
    folder,
    listen,
    locked,
    log_file,
    read_address,
    remove_stale_sockets,
    write_address,
)

MOST_FILES = 4096
CONNECT_S = 3.0
"""After this many seconds without an accepted connection, a machine is considered stuck."""


class CannotConnect(OSError):
    """A machine runs, but it does not accept the connection, because too many terminals wait for it."""


def connect(number: str, *, start: bool = True) -> tuple[socket.socket, Address] | None:
    """Return a connection to the machine of a domain and its address. Return None if no machine runs and `start` is False.

    If two terminals call this function at the same time, one of them starts the machine, and both connect to it. The socket
    listens before the machine runs.

    :param number: the ROS_DOMAIN_ID.
    :param start: whether to start a machine if none runs.
    :raises UnsafePlace: when other users can write in the folder of the machines.
    :raises CannotConnect: when a machine runs but does not accept connections.
    """
    place = folder()
    found = open_connection(read_address(place, number))
    if found is not None or not start:
        return found
    with locked(place, number):
        found = open_connection(read_address(place, number))
        if found is None:
            remove_stale_sockets(place)
            listener, address = listen(place, number, 'terminals')
            with listener:
                address.pid, address.guardian = _spawn(listener, place, number)
                write_address(place, number, address)
            found = open_connection(address)
    return found


def open_connection(address: Address | None) -> tuple[socket.socket, Address] | None:
    """Return a connection to the machine at an address. Return None if no process listens there.

    :raises CannotConnect: when a process listens but does not answer.
    """
    if address is None:
        return None
    client = socket.socket(socket.AF_INET if address.kind == 'tcp' else socket.AF_UNIX)
    client.settimeout(CONNECT_S)
    try:
        client.connect(('127.0.0.1', int(address.place)) if address.kind == 'tcp' else address.place)
    except (BlockingIOError, TimeoutError):
        client.close()
        raise CannotConnect(f'the machine (process {address.pid}) accepts no more connections{state(address)}') from None
    except (OSError, ValueError):
        client.close()
        return None
    client.settimeout(None)
    return client, address


def state(address: Address) -> str:
    """Return the end of a sentence that describes why a machine does not answer. The string may be empty."""
    if address.host == 'notebook':
        why = f': it belongs to a notebook (process {address.pid}), which runs a cell'
        return f'{why}\n  help: wait for the end of the cell, or interrupt it'
    try:
        with open(busy_file(folder(), domain()), encoding='utf-8') as file:
            pid, _, text = file.read(4096).partition('\n')
    except OSError:
        return ''
    return f': {text.rstrip()}' if pid == str(address.pid) else ''


def _spawn(listener: socket.socket, place: str, number: str) -> tuple[int, int]:
    """Start a guardian and its child process, the machine.

    Both are independent of terminals. Return (machine's pid, guardian's pid).
    """
    reader, writer = os.pipe()
    child = os.fork()
    if child:
        os.close(writer)
        os.waitpid(child, 0)
        with open(reader, 'rb') as answer:
            pid, guardian = map(int, answer.read().split() or (0, 0))
            return pid, guardian
    try:
        os.setsid()
        if os.fork() == 0:
            beats, beat = os.pipe()
            machine = os.fork()
            if machine == 0:
                _become('edulaunch.desk.machine.serving', place, number, files=(listener.fileno(), beat))
            os.write(writer, f'{machine} {os.getpid()}'.encode())
            _become('edulaunch.desk.machine.guardian', place, number, str(machine), files=(beats,))
    finally:
        os._exit(0)


def _become(module: str, place: str, number: str, *words: str, files: tuple[int, ...]) -> None:
    """Replace this process by one of our modules. Its log receives standard output and standard error.

    :param module: the name of the module.
    :param place: the folder of the machines.
    :param number: the ROS_DOMAIN_ID.
    :param words: further words of the command line.
    :param files: open files, which the module receives as file descriptors 3, 4 and so on.
    """
    import fcntl

    is_machine = module.endswith('serving')
    flags = os.O_WRONLY | os.O_CREAT | (os.O_TRUNC if is_machine else os.O_APPEND)
    complaints = os.open(log_file(place, number), flags | os.O_APPEND, 0o600)
    nothing = os.open(os.devnull, os.O_RDWR)
    ours = [nothing, complaints, complaints, *files]
    # numbers above all targets, so that no dup2 overwrites one
    high = [fcntl.fcntl(file, fcntl.F_DUPFD, len(ours)) for file in ours]
    for target, file in enumerate(high):
        os.dup2(file, target)
    os.closerange(len(ours), MOST_FILES)
    os.chdir('/')
    os.environ.setdefault('PYTHONHASHSEED', '0')  # sets of strings have the same order in every machine
    os.execv(sys.executable, [sys.executable, '-m', module, place, number, *words])
