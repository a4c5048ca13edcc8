"""What a signal does to a program with a handler and without one."""

from __future__ import annotations

import signal
from typing import Any

import pytest

from edulaunch.engine.processes.signals import DEADLY
from edulaunch.engine.processes.spec import Signals

WAITS = """
import signal, time
{before}
try:
    time.sleep(5)
    print('slept', time.monotonic())
except KeyboardInterrupt:
    print('interrupted', time.monotonic())
finally:
    print('at last')
"""


def sent(world: Any, number: int, before: str = '') -> tuple[int | None, str]:
    """Send a signal after a second; returns the exit code, and what the program wrote."""
    process = world.start(world.write('waits.py', WAITS.format(before=before)), 'waits-1')
    world.sim.schedule(world.sim.now_ns + 10**9, lambda: process.send_signal(number))
    world.sim.run()
    return process.returncode, ''.join(text for _, _, text in world.log)


@pytest.mark.parametrize('number', DEADLY)
def test_without_a_handler_it_ends_the_program_and_no_finally_has_an_effect(world: Any, number: Signals) -> None:
    assert sent(world, number) == (-number, '')


def test_ctrl_c_is_an_exception_where_the_program_waits(world: Any) -> None:
    assert sent(world, signal.SIGINT) == (0, 'interrupted 1.0\nat last\n')


@pytest.mark.parametrize('number', [signal.SIGCHLD, signal.SIGWINCH, signal.SIGURG])
def test_others_are_ignored(world: Any, number: int) -> None:
    assert sent(world, number) == (0, 'slept 5.0\nat last\n')


@pytest.mark.parametrize('number', [signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGUSR1])
def test_a_handler_gets_it_while_the_program_waits_and_the_program_goes_on(world: Any, number: int) -> None:
    before = f'signal.signal({int(number)}, lambda number, frame: print("got", int(number), time.monotonic()))'
    assert sent(world, number, before) == (0, f'got {int(number)} 1.0\nslept 5.0\nat last\n')


def test_nothing_happens_to_a_program_that_has_ended(world: Any) -> None:
    process = world.start(world.write('ends.py', 'raise SystemExit(4)'), 'ends-1')
    world.sim.run()
    process.send_signal(signal.SIGKILL)
    world.sim.run()
    assert process.returncode == 4


@pytest.mark.parametrize(('number', 'forced'), [(signal.SIGTERM, True), (signal.SIGKILL, True), (signal.SIGHUP, False)])
def test_where_a_program_waits_is_kept_when_it_is_forced_to_end(world: Any, number: int, forced: bool) -> None:
    from edulaunch.engine.processes.signals import SignalDelivery

    told: list[tuple[int, list[dict[str, Any]]]] = []
    process = world.start(world.write('waits.py', WAITS.format(before='')), 'waits-1')
    world.sim.run(world.sim.now_ns + 10**9)
    SignalDelivery(process.lifecycle, lambda number, waits: told.append((number, waits))).deliver(number)
    assert [each for each, _ in told] == ([number] if forced else [])
    for _, waits in told:
        assert [(wait['line'], wait['function'], wait['calls']) for wait in waits] == [(5, '<module>', 'time.sleep')]
    world.sim.run()
