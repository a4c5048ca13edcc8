"""Find and record the addresses of machines.

A folder that only its user may enter contains one small file for each ROS_DOMAIN_ID. Each installation of edulaunch has its own
folder, because the machine of another installation may have other packages or another version.
"""

from __future__ import annotations

import os
import socket
import stat
import zlib

LISTENER = 3
"""The file descriptor of the socket that already listens for a new machine."""
HEARTBEAT = 4
"""The file descriptor of a new machine's pipe to its guardian."""
BEATS = 3
"""The file descriptor of the guardian's end of that pipe."""
IDLE_SIGN, BUSY_SIGN = '+\n', '-\n'
"""The messages in the pipe: the machine waits for terminals, or a program has not yielded since the last message."""
LONGEST_SOCKET_PATH = 103
"""The longest path of a socket on macOS, in bytes. Linux allows 107 bytes."""
BACKLOG = 256


class UnsafePlace(Exception):
    """The folder of the machines belongs to another user, or other users may write in it."""


class NoTerminals(UnsafePlace):
    """The operating system lacks a function that the shared machine needs: fork, file locks or poll."""

    def __init__(self) -> None:
        super().__init__(
            'the shared machine needs Linux or macOS\n'
            '  help: use WSL or GitHub Codespaces, where everything works; on this system you can use `edulaunch launch`, '
            '`edulaunch explain`,\n        edulaunch.run() in Python, the lessons in JupyterLab, and `edugrade`'
        )


class Address:
    """The address of a machine.

    This is an ordinary class, because importing `typing` takes longer than everything else that a terminal needs.

    :ivar kind: 'unix' or 'tcp'.
    :ivar place: the path of the socket, or the number of a port on 127.0.0.1.
    :ivar token: the secret that a terminal must send.
    :ivar pid: the id of the process that hosts the machine.
    :ivar host: 'terminals', or 'notebook' if a notebook's kernel hosts the machine.
    :ivar guardian: the id of the process that watches the machine, or 0 for a notebook.
    """

    def __init__(self, kind: str, place: str, token: str, pid: int, host: str, guardian: int = 0) -> None:
        self.kind, self.place, self.token, self.pid, self.host, self.guardian = kind, place, token, pid, host, guardian

    def lines(self) -> list[str]:
        """Return the lines of the file that contains this address."""
        return [self.kind, self.place, self.token, str(self.pid), self.host, str(self.guardian)]


def domain() -> str:
    """Return the ROS_DOMAIN_ID of this terminal. Return '0' if the variable is not set or invalid."""
    given = os.environ.get('ROS_DOMAIN_ID', '').strip()
    return given if given.isdigit() else '0'


def installation() -> str:
    """Return six hexadecimal digits that identify this installation of edulaunch."""
    return f'{zlib.crc32(os.fsencode(os.path.realpath(__file__))):08x}'[:6]


def folder() -> str:
    """Return the folder of the machines. Create the folder if necessary.

    :raises UnsafePlace: when other users can write in the folder.
    :raises NoTerminals: when the operating system does not support the shared machine.
    """
    if not hasattr(os, 'fork'):
        raise NoTerminals
    runtime = os.environ.get('XDG_RUNTIME_DIR', '')
    user = getattr(os, 'getuid', lambda: 0)()
    if runtime and os.path.isdir(runtime) and os.access(runtime, os.W_OK):
        path = os.path.join(runtime, f'edulaunch-{installation()}')
    else:
        path = os.path.join(os.environ.get('TMPDIR') or '/tmp', f'edulaunch-{user}-{installation()}')
    if not os.path.lexists(path):
        _make(path)
    found = os.lstat(path)
    if not stat.S_ISDIR(found.st_mode) or found.st_uid != user or stat.S_IMODE(found.st_mode) & 0o077:
        raise UnsafePlace(
            f'other users can enter {path}, or it is not a folder\n'
            '  help: remove it, or set XDG_RUNTIME_DIR to a folder that only you can enter'
        )
    return path


def _make(path: str) -> None:
    try:
        os.mkdir(path, 0o700)
    except FileExistsError:  # another terminal was faster
        return


def address_file(place: str, number: str) -> str:
    """Return the path of the file that contains the address of a domain's machine."""
    return os.path.join(place, f'domain-{number}')


def read_address(place: str, number: str) -> Address | None:
    """Return the recorded address of a domain's machine, even if the machine has ended. Return None if no valid address is
    recorded.
    """
    try:
        with open(address_file(place, number), encoding='utf-8') as file:
            kind, where, token, pid, host, guardian = (file.read(4096).split('\n') + [''])[:6]
        return Address(kind, where, token, int(pid), host, int(guardian or 0))
    except (OSError, ValueError):
        return None


def write_address(place: str, number: str, address: Address) -> None:
    """Record the address of a machine, so that terminals find it. Readers see the whole old file or the whole new file."""
    path = address_file(place, number)
    new = f'{path}.{os.getpid()}'
    with open(os.open(new, os.O_WRONLY | os.O_CREAT | os.O_TRUNC, 0o600), 'w', encoding='utf-8') as file:
        file.write('\n'.join(address.lines()) + '\n')
    os.replace(new, path)


def remove_address(place: str, number: str, address: Address) -> None:
    """Remove the socket and the recorded address of this machine. The address of a newer machine is not removed."""
    found = read_address(place, number)
    paths = [address_file(place, number)] if found is not None and found.token == address.token else []
    for path in [*paths, *([address.place] if address.kind == 'unix' else [])]:
        if os.path.exists(path):
            os.unlink(path)


def remove_stale_sockets(place: str) -> None:
    """Remove the sockets of killed machines, on which no process listens."""
    for entry in os.scandir(place):
        if not stat.S_ISSOCK(entry.stat(follow_symlinks=False).st_mode):
            continue
        with socket.socket(socket.AF_UNIX) as asked:
            asked.setblocking(False)
            try:
                asked.connect(entry.path)
            except ConnectionRefusedError:
                os.unlink(entry.path)
            except OSError:  # the queue of the socket is full, so a machine listens there
                continue


class locked:
    """A context manager that keeps other processes from starting or ending a machine of a domain at the same time.

    The lock is also released when its process ends.
    """

    def __init__(self, place: str, number: str) -> None:
        self._path = os.path.join(place, f'lock-{number}')
        self._file = -1

    def __enter__(self) -> None:
        import fcntl

        self._file = os.open(self._path, os.O_RDWR | os.O_CREAT, 0o600)
        fcntl.flock(self._file, fcntl.LOCK_EX)

    def __exit__(self, *_: object) -> None:
        os.close(self._file)


def listen(place: str, number: str, host: str) -> tuple[socket.socket, Address]:
    """Return a listening socket that only this user can reach, and its address.

    The socket is a Unix socket, or a loopback port that requires the token.

    :param place: the folder of the machines.
    :param number: the ROS_DOMAIN_ID.
    :param host: 'terminals' or 'notebook'.
    """
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


def busy_file(place: str, number: str) -> str:
    """Return the path of the file in which the guardian describes a machine that does not answer.

    The file exists only while the machine does not answer.
    """
    return os.path.join(place, f'domain-{number}.busy')


def seconds_from(name: str, usual: float) -> float:
    """Return the number of seconds in an environment variable, or `usual` if the variable has no valid number."""
    try:
        return float(os.environ.get(name, usual))
    except ValueError:
        return usual


def log_file(place: str, number: str) -> str:
    """Return the path of a machine's log file."""
    return os.path.join(place, f'domain-{number}.log')
