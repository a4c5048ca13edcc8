"""What takes too long in the grader's own process is ended."""

from __future__ import annotations

import signal
import threading

import pytest
from edugrade.cpu_limit import TooLong, cpu_limit


def test_an_endless_loop_is_ended_and_the_timer_put_back() -> None:
    before = signal.getsignal(signal.SIGPROF)
    with pytest.raises(TooLong, match='longer than 0.05 s'), cpu_limit(0.05):
        while True:
            pass
    assert (signal.getsignal(signal.SIGPROF), signal.getitimer(signal.ITIMER_PROF)) == (before, (0.0, 0.0))


def test_quick_work_is_left_alone() -> None:
    with cpu_limit(5.0):
        found = sum(range(10))
    assert (found, signal.getitimer(signal.ITIMER_PROF)) == (45, (0.0, 0.0))


def test_another_thread_goes_without() -> None:
    found: list[int] = []

    def work() -> None:
        with cpu_limit(1.0):
            found.append(1)

    thread = threading.Thread(target=work)
    thread.start()
    thread.join()
    assert found == [1]
