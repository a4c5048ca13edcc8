"""Hides from this process what Windows lacks, then runs a Python file in it: ``python -m tests.platforms.windows FILE [WORDS]``.

There is no Windows machine here. This finds modules, functions, signals and socket families that are not there, links that may not be
made, and text files opened without an encoding; it cannot find what comes of another path separator, of ``\\r\\n`` or of locked files.
"""

from __future__ import annotations

# Loaded before anything is hidden: on Windows these have other insides, which this Python does not have.
import asyncio  # noqa: F401
import concurrent.futures
import ctypes  # noqa: F401
import enum
import importlib
import logging.handlers  # noqa: F401
import multiprocessing.popen_fork
import multiprocessing.synchronize  # noqa: F401
import os
import runpy
import select
import shutil  # noqa: F401
import signal
import site  # noqa: F401
import socket
import ssl  # noqa: F401
import subprocess
import sys
import sysconfig
import tempfile  # noqa: F401
import time
import uuid  # noqa: F401
import warnings
import zipfile  # noqa: F401
from typing import Any, NoReturn

MODULES = ('fcntl', 'pty', 'resource', 'termios', 'tty', 'pwd', 'grp', 'syslog', 'readline', 'crypt', 'spwd')
OF_OS = """
    fork forkpty killpg setsid getsid getuid geteuid getgid getegid getgroups getpgid getpgrp setpgid setuid setgid wait wait3
    wait4 waitid WNOHANG WUNTRACED mkfifo mknod openpty login_tty posix_spawn posix_spawnp register_at_fork sched_getaffinity
    sched_yield O_CLOEXEC O_NONBLOCK O_NOFOLLOW O_DIRECTORY O_PATH uname getloadavg statvfs chown fchown lchown fchmod sysconf
    confstr sync ctermid tcgetpgrp tcsetpgrp pread pwrite preadv pwritev readv writev nice chroot initgroups pipe2 getrandom
    memfd_create pidfd_open eventfd getpriority setpriority lockf posix_fallocate
"""
SIGNALS = {'SIGINT': 2, 'SIGILL': 4, 'SIGFPE': 8, 'SIGSEGV': 11, 'SIGTERM': 15, 'SIGBREAK': 21, 'SIGABRT': 22}
OF_SIGNAL = """
    setitimer getitimer ITIMER_REAL ITIMER_PROF ITIMER_VIRTUAL ItimerError alarm pause pthread_sigmask pthread_kill sigpending
    sigwait sigwaitinfo sigtimedwait siginterrupt SIG_BLOCK SIG_UNBLOCK SIG_SETMASK Sigmasks pidfd_send_signal
"""


def hide() -> None:
    """Take away what Windows lacks, and let the rest do as it does there."""
    for name in MODULES:
        sys.modules[name] = None  # type: ignore[assignment]
    _remove(os, OF_OS)
    _remove(select, 'poll epoll kqueue')
    _remove(socket, 'AF_UNIX SO_PEERCRED send_fds recv_fds CMSG_LEN CMSG_SPACE SCM_RIGHTS')
    _remove(time, 'clock_gettime clock_gettime_ns pthread_getcpuclockid tzset')
    os.symlink = os.link = _no_links
    _hide_signals()
    sockets_only = select.select

    def only_sockets(*ends: Any) -> Any:
        if any(not isinstance(end, socket.socket) for group in ends[:3] for end in group):
            raise OSError(10038, 'An operation was attempted on something that is not a socket')
        return sockets_only(*ends)

    select.select = only_sockets
    sys.platform = 'win32'


def _hide_signals() -> None:
    _remove(signal, OF_SIGNAL)
    _remove(signal, ' '.join(name for name in dir(signal) if name.startswith('SIG') and name[3:].isalnum()))
    known: Any = enum.IntEnum('Signals', SIGNALS)  # type: ignore[misc]
    signal.Signals = known  # type: ignore[misc,assignment]
    vars(signal).update(known.__members__)
    real = signal.signal

    def only_known(number: int, handler: Any) -> Any:
        if number not in SIGNALS.values():
            raise ValueError('invalid signal value')
        return real(number, handler)

    signal.signal = only_known  # type: ignore[assignment]


def _remove(module: Any, names: str) -> None:
    for name in names.split():
        vars(module).pop(name, None)


def _no_links(*args: object, **kwargs: object) -> NoReturn:
    raise OSError(22, 'A required privilege is not held by the client', None, 1314)


if __name__ == '__main__':
    sysconfig.get_config_vars()  # reads a file that is named after the platform
    assert subprocess and concurrent.futures
    for known in os.environ.get('KNOWN_THERE', '').split():  # what has other insides there, too, and works
        importlib.import_module(known)
    warnings.filterwarnings('error', category=EncodingWarning, module='edulaunch|edugrade')  # with -X warn_default_encoding
    hide()
    del sys.argv[0]
    runpy.run_path(sys.argv[0], run_name='__main__')
