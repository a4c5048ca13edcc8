"""The terminal's side of the connection: send a command to the machine, and show the output to a user or a calling program.

This module imports only the standard library.
"""

from __future__ import annotations

import os
import signal
import socket
import sys
import time
from collections.abc import Callable, Mapping, Sequence

from edulaunch.desk.machine import wire
from edulaunch.desk.machine.following import GIVE_UP_S, Follower, GaveUp, window_size
from edulaunch.desk.machine.place import Address, UnsafePlace, domain, folder, locked, log_file, read_address, remove_address
from edulaunch.desk.machine.starting import CannotConnect, connect, open_connection, state
from edulaunch.errors import fault_text
from edulaunch.runtime.framing import Frames, frame

ANSWER_S = 3.0
"""A running machine has this many seconds to answer `edulaunch machine ...`. After that, the terminal stops waiting."""
STOP_S = 5.0
"""A guardian has this many seconds to end its machine."""
END_S = 15.0
"""A command has this many seconds to end after Ctrl-C."""
LOG_S = 1.0
"""The guardian has this many seconds to write why the machine ended."""


def run(words: Sequence[str], *, start: bool = True) -> int:
    """Run a command of this terminal on the machine of its domain. Return the exit code.

    :param words: the command, such as ['ros2', 'node', 'list'].
    :param start: whether to start a machine if none runs. If False, print an error instead.
    """
    _open_the_closed()
    for _ in range(3):  # a machine may end during the connection
        try:
            found = connect(domain(), start=start)
        except (UnsafePlace, CannotConnect) as error:
            stuck = read_address(folder(), domain()) if words[:2] == ['machine', 'stop'] else None
            return _failed(str(error)) if stuck is None else _stop_by_force(stuck)
        except OSError as error:
            return _failed(f'cannot reach or start the machine of your terminals: {fault_text(error)}')
        if found is None:
            return _failed(f'no machine is running in ROS_DOMAIN_ID {domain()}: start one with any `ros2` command')
        code = _follow(*found, words, ANSWER_S if words[:1] == ['machine'] and not start else GIVE_UP_S)
        if code is not None:
            return code
    return _failed(f'the machine ends as soon as it starts{_reason()}')


def _follow(connection: socket.socket, address: Address, words: Sequence[str], patience_s: float) -> int | None:
    """Follow a command to its end. Return its exit code, or None if the machine ended before it accepted the command."""
    follower = Follower(connection, lambda: state(address), patience_s)
    with connection:
        try:
            code = follower.run(hello(address.token, words))
        except GaveUp as error:
            if words[:2] == ['machine', 'stop']:
                return _stop_by_force(address)
            if words[:1] != ['machine']:
                sys.stderr.write('\nthe machine does not answer; this terminal has left it\n')
            return error.code
        except OSError as error:
            return _failed(f'the connection to the machine broke: {fault_text(error)}')
    if code is None and (follower.is_welcome or follower.has_explained or _complaint()):  # a new machine would hide the reason
        return _failed(f'the machine has ended{_reason()}')
    return code


def _reason() -> str:
    """Return the end of a sentence that gives the reason why the machine ended, or an empty string if its log is empty."""
    path, deadline = log_file(folder(), domain()), time.monotonic() + LOG_S
    while not (text := _complaint()) and time.monotonic() < deadline:
        time.sleep(0.05)
    return f':\n  {text}' if 0 < text.count('\n') < 3 or (text and '\n' not in text) else f'\n  help: see {path}' if text else ''


def _complaint() -> str:
    """Return the content of the machine's log file. The log of a machine that ended normally is empty."""
    try:
        with open(log_file(folder(), domain()), encoding='utf-8', errors='replace') as file:
            return file.read().strip()
    except OSError:
        return ''


def _stop_by_force(address: Address) -> int:
    """End a machine that does not answer, and return the exit code.

    The guardian ends it, or this process if there is no guardian.
    """
    if address.host == 'notebook':
        return _failed('the machine belongs to a notebook: restart its kernel to end it')
    steps = [(address.guardian, signal.SIGTERM), (address.pid, signal.SIGKILL)]
    for pid, signum in steps if address.guardian else steps[1:]:
        try:
            os.kill(pid, signum)
        except ProcessLookupError:
            continue
        deadline = time.monotonic() + STOP_S
        while time.monotonic() < deadline:
            if not _is_there(address):
                with locked(folder(), domain()):
                    remove_address(folder(), domain(), address)
                print('the machine did not answer, so it was killed')
                return 0
            time.sleep(0.05)
    return _failed(f'process {address.pid} does not end')


def _is_there(address: Address) -> bool:
    """Return whether a process still listens at the address."""
    try:
        found = open_connection(address)
    except CannotConnect:
        return True
    if found is not None:
        found[0].close()
    return found is not None


def _open_the_closed() -> None:
    """Open the file descriptors 0, 1 and 2 if they are closed, so that no other file gets one of these numbers."""
    for number in range(3):
        try:
            os.fstat(number)
        except OSError:
            os.open(os.devnull, os.O_RDWR)


def _failed(why: str) -> int:
    sys.stderr.write(f'error: {why}\n')
    return 1


def hello(
    token: str, words: Sequence[str], cwd: str | None = None, env: Mapping[str, str] | None = None, keyboard: bool = True
) -> bytes:
    """Return the first frame of a connection. The frame contains the token, the folder, the window, the command and the
    environment.

    :param token: the secret of the machine.
    :param words: the command.
    :param cwd: the folder of the command (default: the current folder).
    :param env: the environment of the command (default: the environment of this process).
    :param keyboard: whether to report which streams of this process are terminals.
    """
    columns, lines = window_size()
    terminals = ''.join('1' if keyboard and os.isatty(number) else '0' for number in range(3))
    variables = [f'{name}={value}' for name, value in (os.environ if env is None else env).items()]
    fields = [token, cwd or os.getcwd(), str(columns), str(lines), terminals, str(len(words)), *words, *variables]
    return frame(wire.HELLO, wire.pack(fields))


def has_terminals_machine() -> bool:
    """Return whether a machine that a terminal has started runs in this domain."""
    try:
        address = read_address(folder(), domain())
        found = connect(domain(), start=False) if address is not None and address.host == 'terminals' else None
    except (UnsafePlace, OSError):
        return False
    if found is not None:
        found[0].close()
    return found is not None


def ask(words: Sequence[str], write: Callable[[str, str], object], *, seconds: float | None = None) -> int | None:
    """Run a command on the running machine. Return its exit code, or None if no machine runs.

    :param words: the command.
    :param write: a function that receives the output, as write('stdout' | 'stderr', text).
    :param seconds: the real time in seconds after which the command receives SIGINT (default: :data:`GIVE_UP_S`).
    """
    found = connect(domain(), start=False)
    if found is None:
        return None
    connection, address = found
    frames = Frames(wire.FROM_MACHINE)
    steps = [(b'', GIVE_UP_S if seconds is None else seconds), (frame(wire.SIGNAL, b'%d' % signal.SIGINT), END_S)]
    with connection:
        connection.settimeout(ANSWER_S)
        connection.sendall(hello(address.token, words, keyboard=False))
        for event, patience_s in steps:
            connection.sendall(event)
            deadline = time.monotonic() + patience_s
            while (left_s := deadline - time.monotonic()) > 0:
                connection.settimeout(left_s)
                try:
                    data = connection.recv(1 << 16)
                except TimeoutError:
                    break
                for kind, payload in frames.feed(data):
                    if kind in (wire.OUTPUT, wire.ERRORS):
                        write('stdout' if kind == wire.OUTPUT else 'stderr', payload.decode('utf-8', 'replace'))
                    elif kind == wire.EXIT:
                        return int(payload)
                if not data:
                    return None
    write('stderr', f'error: the machine of the terminals does not answer{state(address)}\n')
    return 1
