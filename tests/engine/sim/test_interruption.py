"""The interrupt button while simulated time passes: the run stops, and no simulated program takes the interrupt for its own."""

from __future__ import annotations

import signal
import sys
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest

import edulaunch
from edulaunch.engine.sim.interruption import Interruption
from edulaunch.engine.sim.simulation import Simulation

LAUNCH = """from launch import LaunchDescription
from launch.actions import ExecuteProcess
def generate_launch_description():
    return LaunchDescription([ExecuteProcess(cmd=['python3', {script!r}], output='screen')])
"""
SCRIPT = """import time
import button
for step in range(10):
    print('step', step)
    time.sleep(1)
    try:
        button.press_at(step)
    except KeyboardInterrupt:
        print('I was interrupted')
"""


def put_button(monkeypatch: pytest.MonkeyPatch, presses: dict[int, int]) -> None:
    """A module in which the person at the notebook sits: presses the button so many times at a step."""

    def press_at(step: int) -> None:
        for _ in range(presses.get(step, 0)):
            signal.raise_signal(signal.SIGINT)

    button: Any = ModuleType('button')
    button.press_at = press_at
    monkeypatch.setitem(sys.modules, 'button', button)


@pytest.fixture
def launch_file(tmp_path: Path) -> Path:
    (tmp_path / 'steps.py').write_text(SCRIPT)
    file = tmp_path / 'steps.launch.py'
    file.write_text(LAUNCH.format(script=str(tmp_path / 'steps.py')))
    return file


def test_run_returns_what_was_recorded_and_says_so(
    launch_file: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    put_button(monkeypatch, {2: 1})
    recording = edulaunch.run(launch_file, duration_s=8.0)
    said = [(row.time_s, row.text) for row in recording.output if row.process == 'python3-1']
    assert said[-1][1] in ('step 2\n', 'step 3\n') and len(said) <= 4 and recording.duration_s == pytest.approx(3.0, abs=0.2)
    assert [one.rule for one in recording.advice] == ['programs.interrupted']
    assert f'(at {recording.duration_s:.2f} s)' in recording.warnings[0]
    assert recording.processes[1].ended_s is None
    assert capsys.readouterr().err == f'note: {recording.warnings[0]}\n'
    assert signal.getsignal(signal.SIGINT) is signal.default_int_handler


@pytest.mark.parametrize('speed', [0.0, 1e6])
def test_a_session_stops_and_can_go_on(launch_file: Path, monkeypatch: pytest.MonkeyPatch, speed: float) -> None:
    put_button(monkeypatch, {1: 1})
    with edulaunch.Session() as session:
        session.launch(launch_file)
        assert session.run(5.0, speed) and session.sim.elapsed_s < 3.0
        assert not session.run(2.0, speed)
        steps = [row[3] for row in session.recorder.output_lines if row[1] == 'python3-1']
    assert steps[:4] == ['step 0\n', 'step 1\n', 'step 2\n', 'step 3\n']


def test_the_second_press_ends_what_keeps_its_turn(launch_file: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    put_button(monkeypatch, {1: 2})
    with edulaunch.Session() as session:
        session.launch(launch_file)
        assert session.run(5.0)
        session.run(0.1)
        assert any(row[3] == 'I was interrupted\n' for row in session.recorder.output_lines)


def test_who_handles_sigint_already_keeps_it() -> None:
    came = []
    before = signal.signal(signal.SIGINT, lambda *_: came.append(1))
    try:
        with Interruption(Simulation()) as interruption:
            signal.raise_signal(signal.SIGINT)
    finally:
        signal.signal(signal.SIGINT, before)
    assert came == [1] and not interruption.came


def test_the_first_press_stops_the_run_and_is_told_once_and_the_second_one_interrupts() -> None:
    sim, log = Simulation(), []
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    try:
        with Interruption(sim, lambda: log.append('told')) as interruption:
            sim.schedule(sim.now_ns + 1, lambda: signal.raise_signal(signal.SIGINT))
            sim.schedule(sim.now_ns + 2, lambda: log.append('after'))
            sim.run()
            assert (log, interruption.came) == (['told'], True)
            with pytest.raises(KeyboardInterrupt):
                signal.raise_signal(signal.SIGINT)
        assert log == ['told'] and signal.getsignal(signal.SIGINT) is signal.default_int_handler
    finally:
        signal.signal(signal.SIGINT, before)
