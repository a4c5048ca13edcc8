"""Real programs of this machine: what they write to, and that nothing of them is left open."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

import pytest
from launch import LaunchDescription, LaunchService
from launch.actions import ExecuteProcess, RegisterEventHandler, SetLaunchConfiguration
from launch.event_handlers import OnProcessIO

import edulaunch

OPEN = '/proc/self/fd'
ASK = 'for stream in 1 2; do if [ -t $stream ]; then echo terminal; else echo pipe; fi >&$stream; done'


def written_by(command: list[str], *before: Any, **options: Any) -> tuple[bytes, bytes]:
    """What the command writes to its stdout and stderr."""
    texts = b'', b''

    def on_io(event: Any) -> None:
        nonlocal texts
        texts = (texts[0] + event.text, texts[1]) if event.from_stdout else (texts[0], texts[1] + event.text)

    service = LaunchService(noninteractive=True)
    service.include_launch_description(
        LaunchDescription(
            [*before, RegisterEventHandler(OnProcessIO(on_stdout=on_io, on_stderr=on_io)), ExecuteProcess(cmd=command, **options)]
        )
    )
    assert service.run() == 0
    return texts


@pytest.mark.parametrize(
    ('wanted', 'configured', 'kind'),
    [(False, None, b'pipe'), (True, None, b'terminal'), (False, 'true', b'terminal'), (True, 'false', b'pipe')],
)
def test_emulate_tty_gives_a_real_program_a_terminal(wanted: bool, configured: str | None, kind: bytes) -> None:
    before = [] if configured is None else [SetLaunchConfiguration('emulate_tty', configured)]
    assert written_by(['sh', '-c', ASK], *before, emulate_tty=wanted) == (kind + b'\n', kind + b'\n')


def test_a_letter_may_come_in_two_pieces() -> None:
    pieces = r"printf '\303'; sleep 0.05; printf '\274b\n\377x\n\303'"
    assert written_by(['sh', '-c', pieces])[0].decode() == 'üb\n\N{REPLACEMENT CHARACTER}x\n\N{REPLACEMENT CHARACTER}'


@pytest.mark.skipif(not os.path.isdir(OPEN), reason='this system does not list open files')
@pytest.mark.parametrize('emulate_tty', [False, True])
def test_nothing_is_lost_and_nothing_stays_open(emulate_tty: bool) -> None:
    written_by(['true'], emulate_tty=emulate_tty)
    before = os.listdir(OPEN)
    out, err = written_by(['sh', '-c', 'seq 20000; echo tail >&2'], emulate_tty=emulate_tty)
    assert out == b''.join(b'%d\n' % number for number in range(1, 20001))
    assert err == b'tail\n'
    assert len(os.listdir(OPEN)) == len(before)


@pytest.mark.skipif(not os.path.isdir(OPEN), reason='this system does not list open files')
@pytest.mark.parametrize('emulate_tty', [False, True])
def test_a_program_that_cannot_be_started_leaves_nothing_open(emulate_tty: bool) -> None:
    before = os.listdir(OPEN)
    assert written_by(['no_such_program'], emulate_tty=emulate_tty) == (b'', b'')
    assert len(os.listdir(OPEN)) == len(before)


def test_four_real_programs_take_as_long_as_one() -> None:
    """Simulated time keeps pace with real time once, not for each of them."""
    import time

    from edulaunch.engine.processes import current_process

    sim, began_s, began_ns = current_process().sim, time.monotonic(), current_process().sim.now_ns
    service = LaunchService(noninteractive=True)
    service.include_launch_description(LaunchDescription([ExecuteProcess(cmd=['sleep', '0.3']) for _ in range(4)]))
    assert service.run() == 0
    real_s = time.monotonic() - began_s
    assert 0 < (sim.now_ns - began_ns) / 1e9 <= real_s + 0.05  # how far it comes while they start, the load decides


def test_a_program_that_never_stops_printing_leaves_others_their_turn(tmp_path: Path) -> None:
    """Launch is not blamed, the clock goes on, and the rest is recorded."""
    (tmp_path / 'yes.launch.py').write_text(
        'from launch import LaunchDescription\nfrom launch.actions import ExecuteProcess, LogInfo, TimerAction\n'
        'def generate_launch_description():\n    return LaunchDescription([ExecuteProcess(cmd=["yes"]),\n'
        '        *(TimerAction(period=0.01 * step, actions=[LogInfo(msg=f"step {step}")]) for step in (1, 3, 5))])\n'
    )
    recording = edulaunch.run(tmp_path / 'yes.launch.py', duration_s=0.06, console=lambda stream, text: None)
    assert [(process.returncode, process.exception) for process in recording.processes] == [(None, None)]
    assert [(row.time_s, row.message) for row in recording.logs if 'step' in row.message] == [
        (0.01, 'step 1'),
        (0.03, 'step 3'),
        (0.05, 'step 5'),
    ]
    assert recording.duration_s == 0.06
