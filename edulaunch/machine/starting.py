"""Finding the machine of this user and domain, and starting it when there is none."""

from __future__ import annotations

import os
import socket
import sys

from edulaunch.machine.place import LISTENER, LONGEST_SOCKET_PATH, Address, folder, locked, read_address, write_address

BACKLOG = 256


def connect(number: str, *, start: bool = True) -> tuple[socket.socket, str] | None:
    """A connection to the machine of a domain, and what one says first on it; None when there is none and `start` is false.

    Of two terminals that come first at the same time one starts the machine, and both are connected to it: the socket listens
    before the machine runs.

    :raises UnsafePlace: when the folder of the machines is not this user's alone.
    """
    place = folder()
    found = _try(read_address(place, number))
    if found is not None or not start:
        return found
    with locked(place, number):
        found = _try(read_address(place, number))
        if found is None:
            listener, address = listen(place, number, 'terminals')
            address.pid = _spawn(listener, place, number)
            write_address(place, number, address)
            listener.close()
            found = _try(address)
    return found


def _try(address: Address | None) -> tuple[socket.socket, str] | None:
    if address is None:
        return None
    client = socket.socket(socket.AF_INET if address.kind == 'tcp' else socket.AF_UNIX)
    try:
        client.connect(('127.0.0.1', int(address.place)) if address.kind == 'tcp' else address.place)
    except (OSError, ValueError):
        client.close()
        return None
    return client, address.token


def listen(place: str, number: str, host: str) -> tuple[socket.socket, Address]:
    """A socket for terminals that only this user can reach: a Unix socket, or a port of the loopback that asks for the token."""
    token = os.urandom(16).hex()
    path = os.path.join(place, f'{number}-{token[:8]}')
    if hasattr(socket, 'AF_UNIX') and len(os.fsencode(path)) <= LONGEST_SOCKET_PATH:
        listener = socket.socket(socket.AF_UNIX)
        before = os.umask(0o177)
        try:
            listener.bind(path)
        finally:
            os.umask(before)
        address = Address('unix', path, token, os.getpid(), host)
    else:
        listener = socket.socket(socket.AF_INET)
        listener.bind(('127.0.0.1', 0))
        address = Address('tcp', str(listener.getsockname()[1]), token, os.getpid(), host)
    listener.listen(BACKLOG)
    return listener, address


def _spawn(listener: socket.socket, place: str, number: str) -> int:
    """Start the machine as a process that belongs to no terminal; returns its pid. What it complains of is in a file."""
    reader, writer = os.pipe()
    child = os.fork()
    if child:
        os.close(writer)
        os.waitpid(child, 0)
        with open(reader, 'rb') as answer:
            return int(answer.read() or 0)
    try:
        os.setsid()
        if os.fork() == 0:
            os.write(writer, str(os.getpid()).encode())
            _become_machine(listener, place, number)
    finally:
        os._exit(0)


def _become_machine(listener: socket.socket, place: str, number: str) -> None:
    complaints = os.open(log_file(place, number), os.O_WRONLY | os.O_CREAT | os.O_TRUNC, 0o600)
    nothing = os.open(os.devnull, os.O_RDWR)
    ours = os.dup(listener.fileno())
    for number_here, file in ((0, nothing), (1, complaints), (2, complaints), (LISTENER, ours)):
        if number_here == file:
            os.set_inheritable(file, True)
        else:
            os.dup2(file, number_here)
    os.closerange(LISTENER + 1, 256)
    os.chdir('/')
    words = [sys.executable, '-m', 'edulaunch.machine.serving', place, number]
    os.execv(sys.executable, words)


def log_file(place: str, number: str) -> str:
    """What a machine complains of is written here."""
    return os.path.join(place, f'domain-{number}.log')
