"""A filter of system calls (seccomp), which allows the calls in a list and refuses all other calls.

This module writes the filter itself, so that it needs no library. A refused call fails with EPERM. From Linux 5.0 on, a
*listener* receives each refused call, so that the report can name it. See `guard.py`.
"""

from __future__ import annotations

import ctypes
import errno
import fcntl
import os
import struct
from collections.abc import Sequence

from . import calls
from .system import prctl, syscall

PR_SET_SECCOMP, MODE_FILTER = 22, 2
SECCOMP, SET_MODE_FILTER, NEW_LISTENER = (317, 277), 1, 8
ALLOW, ERRNO, KILL, NOTIFY = 0x7FFF0000, 0x00050000, 0x80000000, 0x7FC00000
LOAD, EQUAL, GREATER_OR_EQUAL, ANY_BIT, AND, RETURN = 0x20, 0x15, 0x35, 0x45, 0x54, 0x06  # instructions of the packet filter
NUMBER, ARCHITECTURE, FIRST_ARGUMENT = 0, 4, 16  # offsets of these fields in the data of the filter
X32 = 0x40000000  # marks the system calls of the x32 ABI on x86-64
NAMESPACES = 0x7E020080  # flags of clone() that create namespaces
# column of `calls.py`, and the kernel's number for the architecture
ARCHITECTURES = {'x86_64': (0, 0xC000003E), 'aarch64': (1, 0xC00000B7)}

OPTIONS = (1, 2, 3, 15, 16, 23, 29, 30, 39, 0x53564D41)
"""The allowed options of prctl: queries, the name of a thread, its timer slack, the signal when its parent dies, and names of
memory.
"""
REQUESTS = (*range(0x5401, 0x5405), 0x540F, 0x5410, 0x5413, 0x5414, 0x541B, 0x5421, 0x5429, 0x5450, 0x5451, 0x802C542A)
"""The allowed requests of ioctl: settings, size and group of a terminal, the number of waiting bytes, blocking, and
close-on-exec.
"""
COMMANDS = (*range(5), 6, 7, 37, 38, 1030, 1032, 1033, 1034)
"""The allowed commands of fcntl: copies of a descriptor, its flags, locks and seals. Owners of signals, leases, notifications
and sizes of pipes are refused. F_GETLK, which reports the owner of a lock, is refused, too. With read locks on files that all
runs may read, runs could send each other messages. A read lock alone has no effect there, because a run can write-lock only its
own files and, where root grades, its own devices. `flock` is refused altogether.
"""
SOCKET_OPTIONS = (1, 2, 4, 9, 13, 16, 20, 21, 66, 67)
"""The allowed options of setsockopt, such as credentials and timeouts. Sizes of buffers are refused, because their memory
belongs to no process.
"""
STREAM, SEQPACKET, KIND_OF_SOCKET, UNIX = 1, 5, 0xF, 1
RECEIVE, ANSWER = 0xC0502100, 0xC0182101  # ioctl numbers of the listener
NOTE_BYTES = 80


def _instruction(code: int, value: int, if_so: int = 0, if_not: int = 0) -> bytes:
    return struct.pack('=HBBI', code, if_so, if_not, value)


def _argument(index: int, is_upper_half: bool = False) -> bytes:
    return _instruction(LOAD, FIRST_ARGUMENT + 8 * index + 4 * is_upper_half)


def _one_of(values: Sequence[int], refuse: bytes) -> list[bytes]:
    """Return instructions that refuse the call unless the loaded value is one of the given values."""
    tests = [_instruction(EQUAL, value, len(values) - place) for place, value in enumerate(values)]
    return [*tests, refuse, _instruction(RETURN, ALLOW)]


def _looked_at(refuse: bytes) -> dict[str, list[bytes]]:
    """Return the instructions that check the arguments of some calls, by the name of the call."""
    allow = _instruction(RETURN, ALLOW)
    return {
        'clone': [_argument(0), _instruction(ANY_BIT, NAMESPACES, 0, 1), refuse, allow],
        # without clone3, the C library uses clone, whose flags the filter can read
        'clone3': [_instruction(RETURN, ERRNO | errno.ENOSYS)],
        'prlimit64': [_argument(0), *_one_of([0], refuse)],  # allowed only for this process
        'prctl': [_argument(0), *_one_of(OPTIONS, refuse)],
        'ioctl': [_argument(1), *_one_of(REQUESTS, refuse)],
        'setsockopt': [_argument(2), *_one_of(SOCKET_OPTIONS, refuse)],
        'fcntl': [_argument(1), *_one_of(COMMANDS, refuse)],
        # Each datagram can have its own address, which can name any socket in the file system.
        'socketpair': [
            *(_argument(0), _instruction(EQUAL, UNIX, 1), refuse),
            *(_argument(1), _instruction(AND, KIND_OF_SOCKET), *_one_of([STREAM, SEQPACKET], refuse)),
        ],
        'sendto': [
            *(_argument(4), _instruction(EQUAL, 0, 1), refuse),
            *(_argument(4, is_upper_half=True), *_one_of([0], refuse)),
        ],
    }


def column_here() -> int | None:
    """Return this computer's column in `calls.py`, or None for an unknown architecture."""
    return ARCHITECTURES.get(os.uname().machine, (None, 0))[0]


def filter_program(has_listener: bool = False, has_view: bool = False) -> bytes | None:
    """Return the filter for this computer, or None for an unknown architecture.

    :param has_listener: whether a listener answers refused calls.
    :param has_view: whether the run has its own view; see `calls.allowed`.
    """
    column = column_here()
    if column is None:
        return None
    refuse = _instruction(RETURN, NOTIFY if has_listener else ERRNO | errno.EPERM)
    parts = [
        _instruction(LOAD, ARCHITECTURE),
        _instruction(EQUAL, ARCHITECTURES[os.uname().machine][1], 1, 0),
        _instruction(RETURN, KILL),
        _instruction(LOAD, NUMBER),
    ]
    if column == 0:
        parts += [_instruction(GREATER_OR_EQUAL, X32, 0, 1), _instruction(RETURN, ERRNO | errno.EPERM)]
    for number in calls.allowed(column, has_view).values():
        parts += [_instruction(EQUAL, number, 0, 1), _instruction(RETURN, ALLOW)]
    how = _looked_at(refuse)
    for name, number in calls.looked_at(column).items():
        parts += [_instruction(EQUAL, number, 0, len(how[name])), *how[name]]
    parts += [_instruction(GREATER_OR_EQUAL, calls.NEWEST, 0, 1), _instruction(RETURN, ERRNO | errno.ENOSYS)]
    return b''.join([*parts, refuse])


class _Program(ctypes.Structure):
    _fields_ = [('length', ctypes.c_ushort), ('instructions', ctypes.c_char_p)]


def restrict(program: bytes) -> None:
    """Permanently filter the calls of this process and its children. Set PR_SET_NO_NEW_PRIVS first.

    :raises OSError: if the kernel does not support filters.
    """
    prctl(PR_SET_SECCOMP, MODE_FILTER, ctypes.byref(_Program(len(program) // 8, program)))


def restrict_with_listener(program: bytes) -> int:
    """Filter the calls like `restrict`, with a program for a listener. Return the descriptor of the listener.

    :raises OSError: if the kernel does not support listeners, or this process already has one.
    """
    content = _Program(len(program) // 8, program)
    return syscall(SECCOMP[column_here() or 0], SET_MODE_FILTER, NEW_LISTENER, ctypes.byref(content))


def refuse_next(listener: int) -> str | None:
    """Refuse the next call that waits at a listener. Return the name of the call, or None if the calling thread has ended."""
    note = bytearray(NOTE_BYTES)
    try:
        fcntl.ioctl(listener, RECEIVE, note)
        number, call = struct.unpack_from('=Q8xi', note)
        fcntl.ioctl(listener, ANSWER, struct.pack('=QqiI', number, 0, -errno.EPERM, 0))
    except OSError:
        return None
    return calls.name_of(call, column_here() or 0)
