"""The calls of the system that Python has no functions for, and a fork that loses no Ctrl-C."""

from __future__ import annotations

import errno
import os
import signal
import threading

import pytest
from edugrade.job import CAN_FORK
from edugrade.sandbox import system


@pytest.mark.skipif(not CAN_FORK, reason='this system has no fork')
def test_a_ctrl_c_during_a_fork_has_its_effect_after_it(monkeypatch: pytest.MonkeyPatch) -> None:
    seen: list[str] = []

    def interrupted() -> int:
        signal.pthread_kill(threading.get_ident(), signal.SIGINT)  # a signal for the process could reach another thread
        seen.append('forked')
        return 77

    monkeypatch.setattr(os, 'fork', interrupted)
    with pytest.raises(KeyboardInterrupt):
        system.fork()
    assert seen == ['forked']
    assert signal.SIGINT not in signal.pthread_sigmask(signal.SIG_BLOCK, [])


@pytest.mark.skipif(not system.IS_LINUX, reason='the calls are those of Linux')
def test_a_call_of_the_kernel_gives_its_result_or_its_error() -> None:
    getpid, close = (20, 6) if os.uname().machine == 'i686' else (39, 3)
    if os.uname().machine == 'aarch64':
        getpid, close = 172, 57
    assert system.syscall(getpid) == os.getpid()
    with pytest.raises(OSError, match='Bad file descriptor') as caught:
        system.syscall(close, 1 << 20)
    assert caught.value.errno == errno.EBADF
    assert system.prctl(3) in (0, 1, 2), 'whether this process may be dumped'
    with pytest.raises(OSError, match='Invalid argument') as caught:
        system.prctl(1 << 20)
    assert caught.value.errno == errno.EINVAL


@pytest.mark.skipif(not system.IS_LINUX, reason='the calls are those of Linux')
def test_the_capabilities_are_those_that_the_kernel_tells() -> None:
    with open('/proc/self/status', encoding='ascii') as file:
        told = next(int(line.split()[1], 16) for line in file if line.startswith('CapEff'))
    assert system.effective_capabilities() == told & 0xFFFFFFFF


@pytest.mark.skipif(not CAN_FORK, reason='this system has no fork')
def test_a_fork_is_tried_again_after_longer_and_longer_pauses(monkeypatch: pytest.MonkeyPatch) -> None:
    log: list[object] = []

    def fork() -> int:
        log.append('fork')
        if len(log) < enough:
            raise BlockingIOError(errno.EAGAIN, 'no processes left')
        return 77

    monkeypatch.setattr(os, 'fork', fork)
    monkeypatch.setattr(system.time, 'sleep', log.append)
    enough = 5
    assert system.fork() == 77 and log == ['fork', 0.01, 'fork', 0.03, 'fork']
    log.clear()
    enough = 99
    with pytest.raises(BlockingIOError):
        system.fork()
    assert log == ['fork', 0.01, 'fork', 0.03, 'fork', 0.1, 'fork', 0.3, 'fork']
