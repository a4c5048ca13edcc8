"""The recording of a run is kept whatever ends it."""

from __future__ import annotations

import errno
import os
import signal
import sys
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest

import edulaunch
from edulaunch.desk.cli.main import main
from edulaunch.engine.recording import Recording
from edulaunch.engine.recording.views import _VIEWS
from edulaunch.runtime.keeping import DESCRIPTORS, MEMORY_BYTES, Ending, Reserve, spent
from edulaunch.runtime.session import Session

LAUNCH = """from launch import LaunchDescription
from launch.actions import ExecuteProcess
def generate_launch_description():
    return LaunchDescription([ExecuteProcess(cmd=['python3', {script!r}], output='screen')])
"""
SCRIPT = """import time
import fate
for step in range(10):
    print('step', step)
    time.sleep(1)
    fate.strike(step)
"""
ENDING = [signal.SIGTERM, signal.SIGHUP, signal.SIGQUIT]
SPENT = [MemoryError(), OSError(errno.EMFILE, 'Too many open files')]


@pytest.fixture
def launch_file(tmp_path: Path) -> Path:
    (tmp_path / 'steps.py').write_text(SCRIPT)
    (tmp_path / 'steps.launch.py').write_text(LAUNCH.format(script=str(tmp_path / 'steps.py')))
    return tmp_path / 'steps.launch.py'


def strike_with(monkeypatch: pytest.MonkeyPatch, *signals: signal.Signals) -> None:
    """A module whose `strike` sends signals to this program after three steps."""
    fate: Any = ModuleType('fate')
    fate.strike = lambda step: [signal.raise_signal(number) for number in signals if step == 2]
    monkeypatch.setitem(sys.modules, 'fate', fate)


def break_the_engine(monkeypatch: pytest.MonkeyPatch, error: BaseException) -> None:
    """After 3.5 simulated seconds, the simulation itself fails."""
    strike_with(monkeypatch)
    begin = Session.launch

    def fail() -> None:
        raise error

    def launch(self: Session, *words: Any, **options: Any) -> Any:
        self.sim.schedule(self.sim.now_ns + 3_500_000_000, fail)
        return begin(self, *words, **options)

    monkeypatch.setattr(Session, 'launch', launch)


def steps(recording: Recording) -> list[str]:
    return [row.text for row in recording.output if row.process == 'python3-1']


@pytest.mark.parametrize('number', ENDING)
def test_a_command_keeps_its_recording(
    launch_file: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], number: signal.Signals
) -> None:
    strike_with(monkeypatch, number)
    target = launch_file.parent / 'run.rec'
    assert main(['launch', str(launch_file), '--fast', '--record', str(target)]) == 128 + number
    recording = Recording.load(target)
    assert steps(recording)[:3] == ['step 0\n', 'step 1\n', 'step 2\n'] and len(steps(recording)) <= 4
    assert [note.kind for note in recording.notes] == ['interrupted'] and recording.not_repeatable
    assert capsys.readouterr().err.endswith(
        f'note: {number.name} ended the run at {recording.duration_s:.2f} s of simulated time\n'
    )
    assert signal.getsignal(number) is signal.SIG_DFL


@pytest.mark.parametrize('number', ENDING)
def test_a_run_of_a_script_returns_its_recording(
    launch_file: Path, monkeypatch: pytest.MonkeyPatch, number: signal.Signals
) -> None:
    strike_with(monkeypatch, number)
    recording = edulaunch.run(launch_file, duration_s=8.0)
    assert recording.duration_s == pytest.approx(3.0, abs=0.2) and [note.kind for note in recording.notes] == ['interrupted']
    assert signal.getsignal(number) is signal.SIG_DFL


@pytest.mark.parametrize('error', SPENT, ids=repr)
def test_what_is_spent_is_a_sentence_after_the_recording(
    launch_file: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], error: Exception
) -> None:
    break_the_engine(monkeypatch, error)
    target = launch_file.parent / 'run.rec'
    assert main(['launch', str(launch_file), '--fast', '--record', str(target)]) == 1
    assert len(steps(Recording.load(target))) == 4 and Recording.load(target).not_repeatable
    said = capsys.readouterr().err
    assert (
        'error: the run ended early, because its programs used all ' in said
        and '  help: look for a ' in said
        and 'Traceback' not in said
    )
    assert len(steps(edulaunch.run(launch_file, duration_s=8.0))) == 4
    assert 'error: the run ended early, because its programs used all ' in capsys.readouterr().err


@pytest.mark.parametrize('presses', [1, 2])
def test_ctrl_c_while_the_recording_is_written(
    launch_file: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], presses: int
) -> None:
    """The first one does not cost the recording. The second one ends the command."""
    save = Recording.save

    def slow(recording: Recording, path: Path) -> None:
        for _ in range(presses):
            signal.raise_signal(signal.SIGINT)
        save(recording, path)

    launch_file.with_name('steps.py').write_text('import time\nfor step in range(9):\n    time.sleep(1)\n')
    monkeypatch.setattr(Recording, 'save', slow)
    target = launch_file.parent / 'run.rec'
    words = ['launch', str(launch_file), '--fast', '--for', '2', '--record', str(target)]
    if presses == 1:
        assert main(words) == 0 and Recording.load(target).duration_s == 2.0
    else:
        with pytest.raises(KeyboardInterrupt):
            main(words)
        assert not target.exists()
    assert 'note: still writing the recording; press Ctrl-C again to stop without it\n' in capsys.readouterr().err
    assert signal.getsignal(signal.SIGINT) is signal.default_int_handler


def test_a_fault_of_ours_is_raised_after_the_recording(launch_file: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    break_the_engine(monkeypatch, ZeroDivisionError('ours'))
    target = launch_file.parent / 'run.rec'
    with pytest.raises(ZeroDivisionError, match='ours'):
        main(['launch', str(launch_file), '--fast', '--record', str(target)])
    assert len(steps(Recording.load(target))) == 4


def test_advice_that_breaks_costs_no_recording(
    launch_file: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def judge(recording: Recording) -> None:
        raise ValueError('a rule')

    strike_with(monkeypatch)
    monkeypatch.setattr('edulaunch.engine.recording.views._VIEWS', {**_VIEWS, 'judge': judge, 'closing_lines': judge})
    target = launch_file.parent / 'run.rec'
    line = 'warning: edulaunch could not check this run for mistakes (ValueError: a rule)\n'
    assert main(['launch', str(launch_file), '--fast', '--record', str(target)]) == 0
    assert capsys.readouterr().err.startswith(f'{line}recording: {target} (')
    assert len(steps(Recording.load(target))) == 10
    assert len(steps(edulaunch.run(launch_file))) == 10
    assert capsys.readouterr().err == line


def test_a_second_signal_interrupts_and_waits_for_a_save() -> None:
    stopped: list[int] = []
    with Ending(lambda: stopped.append(1)) as ending:
        signal.raise_signal(signal.SIGTERM)
        with pytest.raises(KeyboardInterrupt):
            signal.raise_signal(signal.SIGHUP)
        ending.is_saving = True
        signal.raise_signal(signal.SIGTERM)
    assert stopped == [1] and ending.came == signal.SIGTERM


def test_an_ignored_signal_stays_ignored() -> None:
    before = signal.signal(signal.SIGHUP, signal.SIG_IGN)
    try:
        with Ending() as ending:
            signal.raise_signal(signal.SIGHUP)
            assert ending.came is None
    finally:
        signal.signal(signal.SIGHUP, before)


def test_the_reserve_gives_back_open_files() -> None:
    before = len(os.listdir('/dev/fd'))
    reserve = Reserve()
    assert len(os.listdir('/dev/fd')) == before + DESCRIPTORS
    reserve.release()
    reserve.release()
    assert len(os.listdir('/dev/fd')) == before


def test_a_computer_without_descriptors_runs_without_a_reserve(monkeypatch: pytest.MonkeyPatch) -> None:
    def no_descriptor(*arguments: object) -> int:
        raise OSError(errno.EMFILE, os.strerror(errno.EMFILE))

    with monkeypatch.context() as patched:
        patched.setattr(os, 'open', no_descriptor)
        reserve = Reserve()
    reserve.release()


def test_another_error_is_not_the_fault_of_a_program() -> None:
    assert spent(OSError(errno.ENOENT, 'No such file')) is spent(ValueError()) is spent(None) is None


@pytest.mark.skipif(not os.path.exists('/proc/self/statm'), reason='only Linux tells how much memory a process uses')
def test_the_reserve_takes_no_memory_before_it_is_needed() -> None:
    def used() -> int:
        return int(Path('/proc/self/statm').read_text().split()[1]) * os.sysconf('SC_PAGESIZE')

    before = used()
    reserve = Reserve()
    assert used() - before < MEMORY_BYTES / 4
    reserve.release()
