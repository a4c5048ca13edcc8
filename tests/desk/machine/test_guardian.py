"""A machine that does not answer: in one call of C code, stopped, or with nobody left to watch it."""

from __future__ import annotations

import os
import signal
import socket
import sys
import time
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path

import pytest

from edulaunch.desk.machine import wire
from edulaunch.desk.machine.client import hello
from edulaunch.desk.machine.place import read_address, remove_stale_sockets
from edulaunch.desk.machine.terminals import MOST_PAGES
from edulaunch.runtime.framing import frame
from tests.desk.machine.shells import Desk, Shell
from tests.desk.machine.workspace import make_package

STUCK = """import re
import rclpy
from rclpy.node import Node


class Stuck(Node):
    def __init__(self):
        super().__init__('stuck')
        self.create_timer(0.2, self.tick)
        print('now')

    def tick(self):
        {}


def main():
    rclpy.init()
    rclpy.spin(Stuck())
"""
NEVER_S = '3600'
EDULAUNCH = ['-m', 'edulaunch']


@pytest.fixture
def desk(tmp_path: Path) -> Iterator[Desk]:
    """Terminals whose machine may complain in its log; nothing that it starts stays."""
    found = Desk(tmp_path / 'r', tmp_path / 'home')
    for folder in (found.runtime, found.folder):
        folder.mkdir()
    make_package(
        found.folder, {'sums': STUCK.format('sum(range(10**12))'), 'matches': STUCK.format("re.match('(a+)+b', 'a' * 40)")}
    )
    yield found
    address = read_address(str(found.place), '0')
    found.close()
    if address is not None:
        with suppress(ProcessLookupError):
            os.kill(address.pid, signal.SIGKILL)


def ours(desk: Desk, line: str) -> Shell:
    """Type `edulaunch ...`."""
    shell = Shell(*line.split(), cwd=desk.folder, env=desk.env, program=[sys.executable, *EDULAUNCH])
    desk.shells.append(shell)
    return shell


def begin(desk: Desk, program: str) -> Shell:
    shell = desk.ros2(f'run mine {program}')
    shell.until('now')
    return shell


def test_status_names_the_line_and_stop_ends_it(desk: Desk) -> None:
    desk.env['EDULAUNCH_TURN_LIMIT_S'] = NEVER_S
    stuck = begin(desk, 'sums')
    stuck.wait_for((desk.place / 'domain-0.busy').exists)
    status = ours(desk, 'machine status')
    assert status.end() == 1 and 'sums.py:13 (tick) has run for' in status.output
    stop = ours(desk, 'machine stop')
    assert stop.end() == 0 and 'the machine did not answer, so it was killed' in stop.output
    assert (
        stuck.end() == 1
        and 'the machine has ended:' in stuck.output
        and 'did not answer `edulaunch machine stop`' in stuck.output
    )
    assert desk.said('node list') == ''


def test_a_call_that_looks_for_signals_is_interrupted_and_the_others_go_on(desk: Desk) -> None:
    desk.env['EDULAUNCH_TURN_LIMIT_S'] = '0.2'
    talker = desk.ros2('run demo_nodes_py talker')
    talker.until('Publishing')
    stuck = begin(desk, 'matches')
    assert stuck.end() == 1 and 'matches.py:13' in stuck.output and 'ran for too long' in stuck.output
    before = talker.output.count('Publishing')
    talker.until(lambda output: output.count('Publishing') > before)
    assert desk.log() == ''


def test_a_call_that_does_not_ends_with_its_machine_and_who_waits_is_told(desk: Desk) -> None:
    """A new, empty machine would answer `topic list` as if nothing had happened."""
    desk.env['EDULAUNCH_TURN_LIMIT_S'] = '0.2'
    stuck = begin(desk, 'sums')
    stuck.wait_for((desk.place / 'domain-0.busy').exists)
    waiting = desk.ros2('topic list')
    assert stuck.end() == 1
    assert 'sums.py:13 (tick) ran for' in stuck.output and 'could not be interrupted' in stuck.output
    assert waiting.end() == 1
    assert 'the machine has ended' in waiting.output and 'sums.py:13 (tick) ran for' in waiting.output
    assert desk.said('topic list') == '/parameter_events\n/rosout\n'


def test_three_presses_leave_a_machine_that_is_stopped_and_one_sigterm_does(desk: Desk) -> None:
    talker, other = (desk.ros2('run demo_nodes_py talker') for _ in range(2))
    for each in (talker, other):
        each.until('Publishing')
    os.kill(desk.machine_pid(), signal.SIGSTOP)
    talker.type('\x03')
    talker.until('press Ctrl-C twice more to leave it)')
    for _ in range(2):
        talker.type('\x03')
        talker.until(lambda output, count=talker.output.count('^C'): output.count('^C') > count)
        talker.read(0.2)
    assert talker.end() == 128 + signal.SIGINT and 'this terminal has left it' in talker.output
    other.send(signal.SIGTERM)
    assert other.end() == 128 + signal.SIGTERM
    status = ours(desk, 'machine status')
    assert status.end() == 1 and 'was stopped by a signal' in status.output
    os.kill(desk.machine_pid(), signal.SIGCONT)
    assert desk.said('node list') == ''


def test_a_terminal_whose_keys_nobody_takes_can_be_left(desk: Desk) -> None:
    desk.ros2('run turtlesim turtlesim_node').until('Spawning turtle')
    teleop = desk.ros2('run turtlesim turtle_teleop_key')
    teleop.until("'Q' to quit.")
    os.kill(desk.machine_pid(), signal.SIGSTOP)
    os.set_blocking(teleop.number, False)
    begun_s, typed = time.monotonic(), 0
    while typed < 600_000 and time.monotonic() - begun_s < 5:  # more than a socket holds
        try:
            typed += os.write(teleop.number, b'x' * 1024)
        except BlockingIOError:
            teleop.read(0.01)
    for _ in range(10):  # a busy computer joins signals that come close together
        teleop.send(signal.SIGINT)
        pressed_s = time.monotonic()
        while not teleop.gone() and time.monotonic() < pressed_s + 1:
            teleop.read(0.05)
    assert teleop.end() == 128 + signal.SIGINT


def test_stop_ends_a_machine_without_a_guardian(desk: Desk) -> None:
    desk.ros2('run demo_nodes_py talker').until('Publishing')
    address = read_address(str(desk.place), '0')
    assert address is not None
    os.kill(address.guardian, signal.SIGKILL)
    os.kill(address.pid, signal.SIGSTOP)
    stop = ours(desk, 'machine stop')
    assert stop.end() == 0 and 'so it was killed' in stop.output
    assert '/talker' not in desk.said('node list'), 'a new machine; where it takes its time to start, a note says so'


def test_an_end_from_outside_is_named(desk: Desk) -> None:
    talker = desk.ros2('run demo_nodes_py talker')
    talker.until('Publishing')
    os.kill(desk.machine_pid(), signal.SIGKILL)
    assert talker.end() == 1 and 'was killed from outside (SIGKILL)' in talker.output
    place = desk.place
    talker.wait_for(lambda: not (place / 'domain-0').exists())
    assert {path.name for path in place.iterdir()} == {'domain-0.log', 'lock-0'}


def test_whoever_works_is_told_that_somebody_stops_the_machine(desk: Desk) -> None:
    talker = desk.ros2('run demo_nodes_py talker')
    talker.until('Publishing')
    assert ours(desk, 'machine stop').end() == 0
    assert talker.end() == 1 and 'error: the machine was stopped' in talker.output
    assert desk.log() == ''


def test_many_pages_leave_room_for_terminals(desk: Desk) -> None:
    desk.ros2('run demo_nodes_py talker').until('Publishing')
    address = read_address(str(desk.place), '0')
    assert address is not None
    pages, refused = [], b''
    for _ in range(MOST_PAGES + 264):
        page = socket.socket(socket.AF_UNIX)
        page.settimeout(60)
        page.connect(address.place)
        page.sendall(hello(address.token, ['machine', 'view'], keyboard=False))
        assert page.recv(5) == frame(wire.WELCOME)
        pages.append(page)
    refused = pages[-1].recv(1000)
    assert refused[4] == wire.ERRORS and b'close some of them' in refused
    assert desk.said('node list') == '/talker\n'
    for page in pages:
        page.close()


def test_sockets_of_the_dead_are_removed_and_others_stay(tmp_path: Path) -> None:
    with socket.socket(socket.AF_UNIX) as alive, socket.socket(socket.AF_UNIX) as dead:
        for one, name in ((alive, '0-alive'), (dead, '0-dead')):
            one.bind(str(tmp_path / name))
            one.listen(1)
        dead.close()
        (tmp_path / 'domain-0').write_text('no socket')
        remove_stale_sockets(str(tmp_path))
        assert {path.name for path in tmp_path.iterdir()} == {'0-alive', 'domain-0'}
