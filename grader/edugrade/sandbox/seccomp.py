"""A filter of system calls (seccomp): no network, no looking into other processes, no changing of the system.

The filter is written out here, so that no library is needed. A refused call fails with EPERM, as one without the right to it.
"""

from __future__ import annotations

import ctypes
import errno
import os
import struct

from .system import prctl

PR_SET_SECCOMP, MODE_FILTER = 22, 2
ALLOW, ERRNO, KILL = 0x7FFF0000, 0x00050000, 0x80000000
LOAD, EQUAL, GREATER_OR_EQUAL, ANY_BIT, RETURN = 0x20, 0x15, 0x35, 0x45, 0x06  # instructions of the packet filter's machine
NUMBER, ARCHITECTURE, FIRST_ARGUMENT = 0, 4, 16  # where they stand in what the filter looks at
X32 = 0x40000000  # calls of another kind on x86-64
NAMESPACES = 0x7E020000  # the flags of clone() that make new ones

# Calls by name, with their numbers on x86-64 and on 64-bit ARM.
REFUSED = {
    'socket': (41, 198),
    'ptrace': (101, 117),
    'process_vm_readv': (310, 270),
    'process_vm_writev': (311, 271),
    'process_madvise': (440, 440),
    'process_mrelease': (448, 448),
    'pidfd_getfd': (438, 438),
    'kcmp': (312, 272),
    'shmget': (29, 194),
    'semget': (64, 190),
    'msgget': (68, 186),
    'mq_open': (240, 180),
    'mount': (165, 40),
    'umount2': (166, 39),
    'pivot_root': (155, 41),
    'chroot': (161, 51),
    'open_tree': (428, 428),
    'move_mount': (429, 429),
    'fsopen': (430, 430),
    'fsconfig': (431, 431),
    'fsmount': (432, 432),
    'fspick': (433, 433),
    'mount_setattr': (442, 442),
    'name_to_handle_at': (303, 264),
    'open_by_handle_at': (304, 265),
    'unshare': (272, 97),
    'setns': (308, 268),
    'bpf': (321, 280),
    'perf_event_open': (298, 241),
    'fanotify_init': (300, 262),
    'userfaultfd': (323, 282),
    'io_uring_setup': (425, 425),
    'io_uring_enter': (426, 426),
    'io_uring_register': (427, 427),
    'add_key': (248, 217),
    'request_key': (249, 218),
    'keyctl': (250, 219),
    'init_module': (175, 105),
    'finit_module': (313, 273),
    'delete_module': (176, 106),
    'kexec_load': (246, 104),
    'kexec_file_load': (320, 294),
    'reboot': (169, 142),
    'swapon': (167, 224),
    'swapoff': (168, 225),
    'sethostname': (170, 161),
    'setdomainname': (171, 162),
    'settimeofday': (164, 170),
    'clock_settime': (227, 112),
    'clock_adjtime': (305, 266),
    'adjtimex': (159, 171),
    'acct': (163, 89),
    'quotactl': (179, 60),
    'syslog': (103, 116),
}
CLONE, CLONE3, PRLIMIT = (56, 220), (435, 435), (302, 261)
ARCHITECTURES = {'x86_64': (0, 0xC000003E), 'aarch64': (1, 0xC00000B7)}  # column above, number that the kernel gives it


def _instruction(code: int, value: int, if_so: int = 0, if_not: int = 0) -> bytes:
    return struct.pack('=HBBI', code, if_so, if_not, value)


def filter_program() -> bytes | None:
    """The filter for this machine; None for an architecture whose numbers are not known here."""
    machine = ARCHITECTURES.get(os.uname().machine)
    if machine is None:
        return None
    column, architecture = machine
    refuse = _instruction(RETURN, ERRNO | errno.EPERM)
    parts = [
        _instruction(LOAD, ARCHITECTURE),
        _instruction(EQUAL, architecture, 1, 0),
        _instruction(RETURN, KILL),
        _instruction(LOAD, NUMBER),
    ]
    if column == 0:
        parts += [_instruction(GREATER_OR_EQUAL, X32, 0, 1), refuse]
    for numbers in REFUSED.values():
        parts += [_instruction(EQUAL, numbers[column], 0, 1), refuse]
    unknown = _instruction(RETURN, ERRNO | errno.ENOSYS)  # the C library then falls back to clone, whose flags can be looked at
    parts += [_instruction(EQUAL, CLONE3[column], 0, 1), unknown]
    parts += [
        _instruction(EQUAL, CLONE[column], 0, 4),
        _instruction(LOAD, FIRST_ARGUMENT),
        _instruction(ANY_BIT, NAMESPACES, 0, 1),
        refuse,
        _instruction(RETURN, ALLOW),
    ]
    parts += [  # another process's limits
        _instruction(EQUAL, PRLIMIT[column], 0, 3),
        _instruction(LOAD, FIRST_ARGUMENT),
        _instruction(EQUAL, 0, 1, 0),
        refuse,
    ]
    return b''.join([*parts, _instruction(RETURN, ALLOW)])


class _Program(ctypes.Structure):
    _fields_ = [('length', ctypes.c_ushort), ('instructions', ctypes.c_char_p)]


def restrict(program: bytes) -> None:
    """Filter this process's calls, and those of all it starts, for good. PR_SET_NO_NEW_PRIVS must have been set.

    :raises OSError: when the kernel has no filters.
    """
    prctl(PR_SET_SECCOMP, MODE_FILTER, ctypes.byref(_Program(len(program) // 8, program)))
