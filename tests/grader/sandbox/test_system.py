"""The calls of the system that Python has no functions for, and a fork that loses no Ctrl-C."""

from __future__ import annotations

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
        signal.pthread_kill(threading.get_ident(), signal.SIGINT)
        seen.append('forked')
        return 77

    monkeypatch.setattr(os, 'fork', interrupted)
    with pytest.raises(KeyboardInterrupt):
        system.fork()
    assert seen == ['forked']
    assert signal.SIGINT not in signal.pthread_sigmask(signal.SIG_BLOCK, [])
