"""What works where Windows lacks things, and what says at once that it does not (see windows.py for what that can find)."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

import edulaunch

pytestmark = pytest.mark.processes

ROOT = Path(__file__).resolve().parents[2]
EXPECTED = 'the shared machine needs Linux or macOS'
SIGNALLING = """
import signal
from launch import LaunchDescription
from launch.actions import EmitEvent, ExecuteProcess, LogInfo, RegisterEventHandler, TimerAction
from launch.event_handlers import OnProcessExit
from launch.events import matches_action
from launch.events.process import SignalProcess

def generate_launch_description():
    action = ExecuteProcess(cmd=['python3', 'waits.py'], output='screen')
    kill = EmitEvent(event=SignalProcess(signal_number='SIGKILL', process_matcher=matches_action(action)))
    told = lambda event, context: LogInfo(msg=f'ended with {event.returncode}')
    return LaunchDescription(
        [action, TimerAction(period=1.0, actions=[kill]), RegisterEventHandler(OnProcessExit(target_action=action, on_exit=told))]
    )
"""


def on_windows(folder: Path, code: str, *words: str, known: str = '') -> subprocess.CompletedProcess[str]:
    """Run this code where everything is hidden that Windows lacks, and a file opened without an encoding is an error."""
    script = folder / 'script.py'
    script.write_text(code, encoding='utf-8')
    temporary = folder / 'tmp'
    temporary.mkdir(exist_ok=True)
    process = subprocess.Popen(
        [sys.executable, '-X', 'warn_default_encoding', '-m', 'tests.platforms.windows', str(script), *words],
        cwd=ROOT,
        env={
            **os.environ,
            'PYTHONPATH': os.pathsep.join([str(ROOT), str(ROOT / 'grader')]),
            'TMPDIR': str(temporary),
            'KNOWN_THERE': known,
        },
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        encoding='utf-8',
    )
    output, errors = ended(process)
    return subprocess.CompletedProcess(process.args, process.returncode, output, errors)


def ended(process: subprocess.Popen[str]) -> tuple[str, str]:
    """Return what a process has printed, when it ends or has only waited for half a minute. A busy computer may take its time."""
    looks, used = 0, 0.0
    while True:
        try:
            return process.communicate(timeout=LOOK_S)
        except subprocess.TimeoutExpired:
            now = processor_time(process.pid)
            looks, used = (looks + 1 if now - used < LEAST_WORK_S else 0), now
            if looks == MOST_IDLE_LOOKS:
                process.kill()


def processor_time(pid: int) -> float:
    """Return the processor time in seconds that a running process has used."""
    fields = Path(f'/proc/{pid}/stat').read_text().rpartition(')')[2].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf('SC_CLK_TCK')


def test_a_process_that_only_waits_is_ended(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys.modules[__name__], 'LOOK_S', 0.2)
    code = "import time; print('said', flush=True); time.sleep(900)"
    process = subprocess.Popen([sys.executable, '-c', code], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    assert ended(process) == ('said\n', '')
    assert process.returncode == -9


LOOK_S, MOST_IDLE_LOOKS, LEAST_WORK_S = 5.0, 6, 0.02
COMMAND = 'import sys; from {} import main; sys.exit(main(sys.argv[1:]))'
EDULAUNCH, EDUGRADE = COMMAND.format('edulaunch.desk.cli.main'), COMMAND.format('edugrade.cli')
ROS2 = 'import sys; from edulaunch.desk.machine.command import ros2; sys.exit(ros2())'


def test_a_launch_of_the_tutorial_gives_the_same_recording_and_a_picture(tmp_path: Path) -> None:
    code = (
        'import edulaunch, sys\n'
        "recording = edulaunch.run('turtle_tf2_py', 'turtle_tf2_demo.launch.py', duration_s=5, seed=3)\n"
        'recording.plot_turtles().save(sys.argv[1])\n'
        'print(sys.platform, recording.digest())\n'
    )
    done = on_windows(tmp_path, code, str(tmp_path / 'turtles.png'), known='matplotlib.font_manager')
    here = edulaunch.run('turtle_tf2_py', 'turtle_tf2_demo.launch.py', duration_s=5, seed=3)
    assert done.stdout == f'win32 {here.digest()}\n', done.stderr
    assert (tmp_path / 'turtles.png').read_bytes()[:4] == b'\x89PNG'


def test_signals_are_those_of_the_simulated_machine(tmp_path: Path) -> None:
    (tmp_path / 'signals.launch.py').write_text(SIGNALLING.replace('waits.py', str(tmp_path / 'waits.py')), encoding='utf-8')
    (tmp_path / 'waits.py').write_text('import signal\nprint(int(signal.SIGUSR1))\nsignal.pause()\n', encoding='utf-8')
    done = on_windows(tmp_path, EDULAUNCH, 'launch', str(tmp_path / 'signals.launch.py'), '--fast', '--for', '3')
    assert '[python3-1] 10\n' in done.stdout + done.stderr
    assert 'ended with -9' in done.stdout + done.stderr


def test_a_real_program_runs_and_is_ended(tmp_path: Path) -> None:
    launch = 'from launch import LaunchDescription\nfrom launch.actions import ExecuteProcess\n'
    launch += (
        'def generate_launch_description():\n'
        "    return LaunchDescription([ExecuteProcess(cmd=['echo', 'real'], emulate_tty=True, output='screen'), ExecuteProcess(cmd=['sleep', '900'])])\n"
    )
    (tmp_path / 'real.launch.py').write_text(launch, encoding='utf-8')
    done = on_windows(tmp_path, EDULAUNCH, 'launch', str(tmp_path / 'real.launch.py'), '--for', '0.5')
    assert '[echo-1] real' in done.stdout + done.stderr
    assert 'process has died [pid' in done.stdout + done.stderr  # Windows ends it, and that is all that it can


@pytest.mark.parametrize('exercise', ['solutions/circle.launch.py', 'exercises/static_frame.launch.py', 'solutions/two_turtles'])
def test_edugrade_says_the_same_as_in_a_confined_run(exercise: str, tmp_path: Path) -> None:
    own, given = tmp_path / Path(exercise).name, ROOT / exercise  # the course's own would note the attempts
    shutil.copytree(given, own) if given.is_dir() else shutil.copy(given, own)
    done = on_windows(tmp_path, EDUGRADE, str(own), '--json', str(tmp_path / 'there.json'))
    assert 'only grade your own files here' in done.stderr
    here = subprocess.run(
        [sys.executable, '-m', 'edugrade', str(own), '--json', str(tmp_path / 'here.json')],
        cwd=ROOT,
        env={**os.environ, 'PYTHONPATH': os.pathsep.join([str(ROOT), str(ROOT / 'grader')])},
        capture_output=True,
        text=True,
        timeout=300,
    )
    assert (done.returncode, done.stdout) == (here.returncode, here.stdout)
    one, two = (json.loads((tmp_path / f'{name}.json').read_text(encoding='utf-8')) for name in ('there', 'here'))
    assert {**one, 'sandbox': None} == {**two, 'sandbox': None}


def test_a_launch_file_that_cannot_be_launched_is_told_of(tmp_path: Path) -> None:
    (tmp_path / 'circle.launch.py').write_text('import nothing_such\n', encoding='utf-8')
    done = on_windows(tmp_path, EDUGRADE, str(tmp_path / 'circle.launch.py'))
    assert (done.returncode, "No module named 'nothing_such'" in done.stdout) == (2, True), done.stdout + done.stderr


def test_what_must_be_confined_is_refused(tmp_path: Path) -> None:
    batch = on_windows(tmp_path, EDUGRADE, 'batch', str(ROOT / 'exercises'))
    strict = on_windows(tmp_path, EDUGRADE, 'solutions/circle.launch.py', '--sandbox', 'require')
    assert (batch.returncode, strict.returncode) == (2, 3)
    assert 'this system has no sandbox for the code of other people\n  help: grade on a Linux' in batch.stderr
    assert 'this system cannot confine a run' in strict.stdout


@pytest.mark.parametrize(
    'words', [['topic', 'list'], ['launch', 'turtlesim', 'multisim.launch.py'], ['run', 'turtlesim', 'turtlesim_node']]
)
def test_terminals_say_at_once_what_to_use(words: list[str], tmp_path: Path) -> None:
    done = on_windows(tmp_path, ROS2, *words)
    assert done.returncode == 1
    assert EXPECTED in done.stderr and 'WSL' in done.stderr and 'Traceback' not in done.stderr


@pytest.mark.parametrize('words', [['view'], ['machine', 'status']])
def test_what_looks_at_the_shared_machine_says_so_too(words: list[str], tmp_path: Path) -> None:
    done = on_windows(tmp_path, EDULAUNCH, *words)
    assert done.returncode != 0
    assert EXPECTED in done.stderr and 'Traceback' not in done.stderr
