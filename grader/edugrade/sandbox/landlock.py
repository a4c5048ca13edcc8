"""Landlock (Linux 5.13): limits which files a process and its children may read and write, and which processes they may signal or
connect to.
"""

from __future__ import annotations

import ctypes
import errno
import os
import stat
from collections.abc import Sequence

from .system import IS_LINUX, syscall

CREATE_RULESET, ADD_RULE, RESTRICT_SELF = 444, 445, 446
VERSION = 1  # flag of CREATE_RULESET that asks for the kernel's version
PATH_BENEATH = 1
EXECUTE, WRITE_FILE, READ_FILE, READ_DIR, TRUNCATE, IOCTL_DEV = 1 << 0, 1 << 1, 1 << 2, 1 << 3, 1 << 14, 1 << 15
READ = EXECUTE | READ_FILE | READ_DIR
OF_DEVICES = READ_FILE | WRITE_FILE | IOCTL_DEV
EVERYTHING = (1 << 64) - 1
OF_FILES = EXECUTE | WRITE_FILE | READ_FILE | TRUNCATE | IOCTL_DEV
NEWEST = 6  # features of later versions are not used
RIGHTS = {1: (1 << 13) - 1, 2: (1 << 14) - 1, 3: (1 << 15) - 1, 4: (1 << 15) - 1, 5: (1 << 16) - 1, 6: (1 << 16) - 1}
BIND_AND_CONNECT_TCP = 3
ABSTRACT_SOCKETS_AND_SIGNALS = 3
OUT_OF_REACH = frozenset({errno.ENOENT, errno.ENOTDIR, errno.EACCES, errno.ELOOP, errno.ENAMETOOLONG})


class _Ruleset(ctypes.Structure):
    _fields_ = [('files', ctypes.c_uint64), ('network', ctypes.c_uint64), ('scoped', ctypes.c_uint64)]


class _PathBeneath(ctypes.Structure):
    _pack_ = 1
    _layout_ = 'ms'
    _fields_ = [('allowed', ctypes.c_uint64), ('folder', ctypes.c_int32)]


def version() -> int:
    """Return the version of Landlock in the kernel, but at most NEWEST. Return 0 without Landlock."""
    try:
        return min(syscall(CREATE_RULESET, None, 0, VERSION), NEWEST) if IS_LINUX else 0
    except OSError:
        return 0


def open_paths(paths: Sequence[str]) -> list[int]:
    """Return open descriptors for the paths that exist and can be reached.

    :raises OSError: if the computer cannot open a path for another reason. A run without this path would blame its submission.
    """
    found = []
    for path in paths:
        try:
            found.append(os.open(path, os.O_PATH | os.O_CLOEXEC))
        except OSError as error:
            if error.errno not in OUT_OF_REACH:
                raise
    return found


def restrict(rules: Sequence[tuple[Sequence[int], int]]) -> int:
    """Permanently limit this process to the given rights below the given paths, and to signals to its own processes.

    :param rules: pairs of descriptors (from `open_paths`) and rights.
    :return: the version of Landlock that was used.
    :raises OSError: if the kernel has no Landlock.
    """
    known = version()
    rights = RIGHTS.get(known, 0)
    handled = _Ruleset(rights, BIND_AND_CONNECT_TCP if known >= 4 else 0, ABSTRACT_SOCKETS_AND_SIGNALS if known >= 6 else 0)
    size = 8 if known < 4 else 16 if known < 6 else 24
    ruleset = syscall(CREATE_RULESET, ctypes.byref(handled), size, 0)
    try:
        for paths, allowed in rules:
            for descriptor in paths:
                mask = rights if stat.S_ISDIR(os.fstat(descriptor).st_mode) else rights & OF_FILES
                rule = _PathBeneath(allowed & mask, descriptor)
                syscall(ADD_RULE, ruleset, PATH_BENEATH, ctypes.byref(rule), 0)
        syscall(RESTRICT_SELF, ruleset, 0)
    finally:
        os.close(ruleset)
    return known
