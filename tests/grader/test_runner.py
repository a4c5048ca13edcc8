"""Every way in which a child can end is a verdict in words, and nothing of it runs afterwards.

A launch file's own `os._exit` ends only its simulated process; these go round that, through `posix`.
"""

from __future__ import annotations

import os
import resource
from pathlib import Path

import pytest
from edugrade import Scenario
from edugrade.evidence import Outcome
from edugrade.job import Limits
from edugrade.places import readable_by_all, shown_to_all
from edugrade.runner import Runner
from edugrade.submission import Submission

pytestmark = pytest.mark.processes

WRITE_TO_ALL = """import posix as os
for fd in range(3, 30):
    try: os.write(fd, {})
    except OSError: pass
"""
EXIT = 'os._exit(0)\n'
HOSTILE = {
    'exits at once': ('import posix as os\n' + EXIT, 'the program ended itself with exit code 0 before the end of the run'),
    'exits with a number': (
        'import posix as os\nos._exit(7)\n',
        'the program ended itself with exit code 7 before the end of the run',
    ),
    'kills itself': ('import posix as os\nos.kill(os.getpid(), 9)\n', 'SIGKILL ended the program before the end of the run'),
    'crashes': ('import posix as os\nos.kill(os.getpid(), 11)\n', 'SIGSEGV ended the program before the end of the run'),
    'sends garbage': (WRITE_TO_ALL.format('b"hello"') + EXIT, 'the run did not return a valid recording'),
    'sends a false recording': (
        WRITE_TO_ALL.format('b"R" + (5).to_bytes(8, "big") + b"12345"') + EXIT,
        'the run did not return a valid recording',
    ),
    'sends half a frame': (
        WRITE_TO_ALL.format('b"R" + (500).to_bytes(8, "big") + b"12345"') + EXIT,
        'the program ended itself with exit code 0 before the end of the run',
    ),
    'sends deep JSON': (
        WRITE_TO_ALL.format('b"U" + (9000).to_bytes(8, "big") + b"[" * 9000') + EXIT,
        'the run did not return a valid recording',
    ),
    'announces too much': (WRITE_TO_ALL.format('b"R" + b"\\xff" * 100') + EXIT, 'the run did not return a valid recording'),
    'closes its pipes': (
        'import posix as os\nos.closerange(3, 30)\n' + EXIT,
        'the program ended itself with exit code 0 before the end of the run',
    ),
    'prints without end': ('import posix as os\nwhile True: os.write(1, b"x" * 100000)\n', 'the run printed more than 1 MiB'),
    'leaves a child': (
        'import posix as os\nif os.fork() == 0:\n    while True: pass\n' + EXIT,
        'the program ended itself with exit code 0 before the end of the run',
    ),
}


def run(
    folder: Path, text: str, wall_s: float = 10.0, memory_mib: int = 2048, sandbox: str = 'auto', turn_s: float = 0.8
) -> Outcome:
    file = folder / 'circle.launch.py'
    file.write_text(text)
    limits = Limits(wall_s, memory_mib=memory_mib, output_mib=1, sandbox=sandbox, turn_s=turn_s)
    with Runner(limits) as runner:
        return runner.wait(runner.add(Submission(str(file)), [Scenario('only')]))[0]


@pytest.mark.parametrize(('text', 'verdict'), HOSTILE.values(), ids=HOSTILE)
def test_a_hostile_submission_gets_a_verdict(tmp_path: Path, text: str, verdict: str) -> None:
    outcome = run(tmp_path, text)
    assert (outcome.kind, outcome.text) == ('stopped', verdict)


def test_an_endless_loop_is_stopped_and_its_line_named(tmp_path: Path) -> None:
    outcome = run(tmp_path, 'x = 1\nwhile True:\n    pass\n', wall_s=0.5)
    assert (outcome.kind, outcome.text) == ('stopped', 'the run did not finish within 0.5 s of real time')
    assert outcome.where is not None
    assert outcome.where.file == str(tmp_path / 'circle.launch.py')
    assert outcome.where.line in (2, 3)


def test_blocking_all_signals_does_not_help_a_loop(tmp_path: Path) -> None:
    text = 'import _signal\n_signal.pthread_sigmask(_signal.SIG_BLOCK, range(1, 65))\nwhile True:\n    pass\n'
    outcome = run(tmp_path, text, wall_s=0.5)
    assert (outcome.kind, outcome.text) == ('stopped', 'the run did not finish within 0.5 s of real time')


KILL_THE_STARTER = (
    'import os, posix\nwhile True:\n    posix.kill(int(open("/proc/" + str(posix.getppid()) + "/stat").read().split()[3]), 9)\n'
)
HARMLESS = """from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([Node(package='turtlesim', executable='turtlesim_node')])
"""


def test_a_submission_that_kills_the_starter_spoils_only_itself(tmp_path: Path) -> None:
    """Unconfined, because a confined one has no /proc and signals nobody."""
    submissions = []
    for name, text in (('bad', KILL_THE_STARTER), ('good', HARMLESS)):
        (tmp_path / f'{name}.launch.py').write_text(text)
        submissions.append(Submission(str(tmp_path / f'{name}.launch.py')))
    with Runner(Limits(10.0, sandbox='off'), processors=1) as runner:
        bad, good = (runner.add(submission, [Scenario('only', {}, 1.0)]) for submission in submissions)
        outcomes = [runner.wait(job)[0] for job in (bad, good)]
    assert [outcome.kind == 'recorded' for outcome in outcomes] == [False, True]


def test_of_a_starter_that_was_killed_no_run_is_lost(tmp_path: Path) -> None:
    """Both runs were sent to it and had not begun; one of them asks for the next starter first."""
    file = tmp_path / 'good.launch.py'
    file.write_text(HARMLESS)
    with Runner(Limits(20.0), processors=2) as runner:
        job = runner.add(Submission(str(file)), [Scenario('one', {}, 1.0), Scenario('two', {}, 1.0)])
        first = runner._starter
        assert first is not None
        first._process.kill()
        outcomes = runner.wait(job)
        assert runner._starter is not first
    assert [outcome.kind for outcome in outcomes] == ['recorded', 'recorded']
    assert list(job.again.values()) == [1, 1]


def test_a_run_finds_nothing_of_the_one_before_it(tmp_path: Path) -> None:
    leave = 'import builtins, os, sys\nbuiltins.left = os.environ["LEFT"] = "x"\nsys.modules["left"] = sys\nraise ValueError("left")\n'
    look = (
        'import builtins, os, sys\nraise ValueError(repr((hasattr(builtins, "left"), "LEFT" in os.environ,'
        ' "left" in sys.modules)))\n'
    )
    texts = []
    with Runner(Limits(10.0), processors=1) as runner:
        for number, text in enumerate((leave, look)):
            file = tmp_path / f'{number}.launch.py'
            file.write_text(text)
            texts.append(runner.wait(runner.add(Submission(str(file)), [Scenario('only')]))[0].text)
    assert 'ValueError: left' in texts[0]
    assert 'ValueError: (False, False, False)' in texts[1]


def test_memory_is_limited(tmp_path: Path) -> None:
    outcome = run(tmp_path, 'x = []\nwhile True:\n    x.append(bytearray(10 ** 7))\n', memory_mib=300)
    assert outcome.kind in ('stopped', 'unusable')
    assert 'memory' in outcome.text.lower()


def test_a_child_has_limits_and_a_home_of_its_own(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv('SECRET', 'of the caller')
    seen = 'resource.getrlimit(resource.RLIMIT_NOFILE)[0], posix.environ.get(b"SECRET"), posix.getcwd()'
    outcome = run(tmp_path, f'import posix, resource\nraise ValueError(repr(({seen})))\n')
    assert "ValueError: (256, None, '/" in outcome.text
    assert '/edugrade-' in outcome.text


DAEMONS = """import posix
for _ in range(20):
    if posix.fork() == 0:
        posix.setsid()
        if posix.fork() == 0:
            posix.setsid()
            posix.write(1, b"%d\\n" % posix.getpid())
            while True: pass
        posix._exit(0)
import time, _thread
lock = _thread.allocate_lock()
lock.acquire()
lock.acquire(True, 0.3)
posix._exit(0)
"""


@pytest.mark.parametrize('sandbox', ['auto', 'off'])
def test_nothing_that_was_started_is_left(tmp_path: Path, sandbox: str) -> None:
    pids = [int(line) for line in run(tmp_path, DAEMONS, sandbox=sandbox).detail.split()]
    assert len(pids) > 10
    assert not any(is_alive(pid) for pid in pids)


def test_a_program_that_starts_itself_is_ended(tmp_path: Path) -> None:
    outcome = run(tmp_path, 'import posix\nwhile True:\n    posix.fork()\n', wall_s=20.0)
    assert outcome.text in ('the run started too many programs', 'the run needed more than 2048 MiB of memory')


def test_memory_counts_for_all_processes_of_a_run_together(tmp_path: Path) -> None:
    text = 'import posix\nfor _ in range(6):\n    if posix.fork() == 0:\n        break\nx = bytearray(b"x" * 150_000_000)\n'
    outcome = run(tmp_path, text + 'while True:\n    pass\n', wall_s=20.0, memory_mib=500)
    assert outcome.text == 'the run needed more than 500 MiB of memory'


def test_the_private_folder_is_removed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv('TMPDIR', str(tmp_path))
    run(tmp_path, 'import posix as os\nopen("left.txt", "w").close()\nos._exit(0)\n')
    assert os.listdir(tmp_path) == ['circle.launch.py']


def is_alive(pid: int) -> bool:
    """Whether the process runs; a killed one whose parent has not asked for it is dead."""
    try:
        return Path(f'/proc/{pid}/stat').read_text().rsplit(')', 1)[1].split()[0] not in 'ZX'
    except OSError:
        return False


LOOPS = {
    'that does nothing': ('x = 1\nwhile True:\n    pass\n', 'the launch file did not finish and was stopped', (2, 3)),
    'in a pattern': ("import re\nre.match('(a+)+$', 'a' * 60 + 'b')\n", 'the launch file did not finish and was stopped', (2,)),
    'in C': ('x = 1\nsum(range(10 ** 13))\n', 'a single call used the processor for seconds and did not return', (2,)),
}


@pytest.mark.parametrize(('text', 'told', 'lines'), LOOPS.values(), ids=LOOPS)
def test_a_loop_is_found_by_the_processors_time_and_its_line_named(
    tmp_path: Path, text: str, told: str, lines: tuple[int, ...]
) -> None:
    outcome = run(tmp_path, text, wall_s=120.0, turn_s=0.2)
    assert (outcome.kind, outcome.text) == ('stopped', told)
    assert outcome.where is not None
    assert (outcome.where.file, outcome.where.line in lines) == (str(tmp_path / 'circle.launch.py'), True)


def test_a_private_folder_full_of_folders_is_removed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv('TMPDIR', str(tmp_path))
    run(
        tmp_path,
        'import posix as os\nfor _ in range(30):\n    os.mkdir("d" * 200, 0o700)\n    os.chdir("d" * 200)\nos._exit(0)\n',
    )
    assert os.listdir(tmp_path) == ['circle.launch.py']


def test_any_number_of_packages_may_be_installed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Beside an installed edugrade every entry of site-packages is a place of its own; JupyterLab brings hundreds."""
    last = tmp_path / 'packages' / 'last.txt'
    last.parent.mkdir()
    last.write_text('read')
    names = [str(tmp_path / 'packages' / f'{"long" * 30}{number}') for number in range(1200)]
    for name in names:
        Path(name).touch()
    read, listed = readable_by_all([])
    monkeypatch.setattr('edugrade.starter_link.readable_by_all', lambda path: ([*read, *names, str(last)], listed))
    shown, hidden = shown_to_all([])
    monkeypatch.setattr('edugrade.starter_link.shown_to_all', lambda path: ([*shown, str(last.parent)], hidden))
    before = resource.getrlimit(resource.RLIMIT_NOFILE)
    resource.setrlimit(resource.RLIMIT_NOFILE, (1024, before[1]))
    try:
        outcome = run(tmp_path, f'open({str(last)!r}).read()\n')
    finally:
        resource.setrlimit(resource.RLIMIT_NOFILE, before)
    assert (outcome.kind, 'generate_launch_description' in outcome.text) == ('unusable', True), outcome.text
