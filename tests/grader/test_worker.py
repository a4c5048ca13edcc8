"""What becomes of judging and drawing costs one submission only.

What takes too long in the grader's own process is ended.
"""

from __future__ import annotations

import json
import signal
import subprocess
import sys
import threading
from importlib import import_module
from pathlib import Path
from time import process_time
from typing import Any

import pytest
from edugrade.cli import main
from edugrade.job import CAN_FORK
from edugrade.worker import TooLong, cpu_limit, in_worker

from edulaunch.engine.interfaces.registry import Registry, underlay_registry

LAUNCH = """
from launch import LaunchDescription
from launch_ros.actions import Node

def generate_launch_description():
    return LaunchDescription([Node(package='turtlesim', executable='turtlesim_node')])  # {word}
"""
RUBRIC = """
import os, re, signal, time
from pathlib import Path
from edugrade import Rubric, Scenario, check

@check(points=2)
def looks(run):
    'It can be looked at'

@check(points=3)
def strains(run):
    'It can be looked at for long'
    word = Path(run.source.place.file).read_text().split('# ')[1].strip()
    if word == 'loop':
        re.match('(a+)+$', 'a' * 60 + 'b')
    if word == 'memory':
        rows = []
        while True:
            rows.append(bytearray(1 << 24))
    if word == 'killed':
        os.kill(os.getpid(), signal.SIGKILL)
    if word == 'once' and not os.path.exists('once'):
        Path('once').touch()
        os.kill(os.getpid(), signal.SIGKILL)

RUBRIC = Rubric(title='Strain', scenarios=lambda random: [Scenario('one', {}, 0.5)], checks=[looks, strains])
"""
GRADE = (
    'import sys, edugrade.worker\nedugrade.worker.LONGEST_CPU_S = 3\nfrom edugrade.cli import main\nsys.exit(main(sys.argv[1:]))'
)


@pytest.mark.whole
def test_judging_that_loops_eats_or_dies_costs_only_its_own_submission(tmp_path: Path) -> None:
    (tmp_path / 'strain.py').write_text(RUBRIC)
    for word in ('bare', 'killed', 'loop', 'memory', 'once', 'right'):
        (tmp_path / 'class' / word).mkdir(parents=True)
        (tmp_path / 'class' / word / 'a.launch.py').write_text(LAUNCH.format(word=word))
    words = ['batch', 'class', '--rubric', 'strain.py', '--out', 'out', '--html', 'html']
    done = subprocess.run([sys.executable, '-c', GRADE, *words], cwd=tmp_path, capture_output=True, text=True, check=False)
    assert (done.returncode, done.stderr) == (3, '')
    found = {path.parent.name: json.loads(path.read_text()) for path in (tmp_path / 'out').rglob('*.json')}
    assert {name: result['points']['earned'] for name, result in found.items()} == {
        'bare': 5,
        'killed': None,
        'loop': 0,
        'memory': 2,
        'once': 5,
        'right': 5,
    }
    reasons = {name: next((each['reason'] for each in found[name]['checks'] if each['reason']), None) for name in found}
    assert 'longer than 3 s of processor time' in reasons['loop']
    assert 'the memory is full' in reasons['memory']
    assert 'Lost: another program killed the process that judges' in reasons['killed']
    assert [each['status'] for each in found['loop']['checks']] == ['failed', 'not_run', 'not_run']
    assert all('<img' in (tmp_path / 'html' / name / 'a.launch.py.html').read_text() for name in found)


WORK = """
import os, json, sys
import edugrade.worker as worker

worker.LONGEST_CPU_S = 1

def tried(work):
    try:
        return worker.in_worker(work)
    except Exception as error:
        return f'{type(error).__name__}: {error}'

def eat():
    return len(bytearray(1 << 31))

def loop():
    while True:
        pass

print('before')
worker_pid = tried(os.getpid)
got = [tried(lambda: ['a' * 300_000, 1.5, None])[1:], tried(eat), tried(loop), tried(lambda: 1 / 0), worker_pid != os.getpid()]
got.append(tried(lambda: sorted(os.listdir('/proc/self/fd'))) if sys.platform.startswith('linux') else ['0', '1', '2'])
import edugrade.worker
tried(lambda: __import__('edugrade.classes.similar') and None)
tried(lambda: None)
got.append('edugrade.classes.similar' in sys.modules)
print(json.dumps(got))
"""


@pytest.mark.processes
def test_the_limits_of_a_worker() -> None:
    done = subprocess.run([sys.executable, '-c', WORK], capture_output=True, text=True, check=True)
    before, said = done.stdout.splitlines()
    got: list[Any] = json.loads(said)
    assert before == 'before'
    assert got[0] == [1.5, None]
    assert got[1] == 'Exceeded: it needed more than 1024 MiB of memory'
    assert got[2] == 'Exceeded: it took longer than 1 s of processor time'
    assert got[3] == 'RuntimeError: ZeroDivisionError: division by zero'
    assert got[4]  # it was another process
    assert len(got[5]) <= 5  # input, output, the answer, and the folder that is listed
    assert got[6]  # what it had to load, the next one has


@pytest.mark.processes
def test_a_report_is_the_same_from_a_worker_and_without_one(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    solution = Path(__file__).parents[2] / 'exercises' / 'circle.launch.py'
    monkeypatch.setattr('threading.active_count', lambda: 2)
    assert main([str(solution), '--json', str(tmp_path / 'without')]) == 1
    words = [str(solution), '--json', str(tmp_path / 'with')]
    subprocess.run([sys.executable, '-m', 'edugrade', *words], capture_output=True, check=False, cwd=tmp_path)
    assert (tmp_path / 'with').read_bytes() == (tmp_path / 'without').read_bytes()


def test_an_endless_loop_is_ended_and_the_timer_put_back() -> None:
    before = signal.getsignal(signal.SIGPROF)
    with pytest.raises(TooLong, match='longer than 0.05 s'), cpu_limit(0.05):
        while True:
            pass
    assert (signal.getsignal(signal.SIGPROF), signal.getitimer(signal.ITIMER_PROF)) == (before, (0.0, 0.0))


class Slow:
    """Python ignores an exception in its destructor."""

    def __init__(self) -> None:
        self.end = process_time() + 1.0

    def __del__(self) -> None:
        while process_time() < self.end:
            pass


def test_a_limit_that_a_destructor_swallows_is_raised_again(capfd: pytest.CaptureFixture[str]) -> None:
    before = sys.unraisablehook
    with pytest.raises(TooLong), cpu_limit(0.05):
        Slow()
        end = process_time() + 1.0
        while process_time() < end:
            pass
    assert (signal.getitimer(signal.ITIMER_PROF), sys.unraisablehook) == ((0.0, 0.0), before)
    assert capfd.readouterr().err == ''


class Broken:
    def __del__(self) -> None:
        raise ValueError('a mistake of the destructor')


def test_another_mistake_of_a_destructor_is_still_reported(monkeypatch: pytest.MonkeyPatch) -> None:
    told: list[object] = []
    monkeypatch.setattr(sys, 'unraisablehook', lambda ignored: told.append(ignored.exc_type))
    with cpu_limit(5.0):
        Broken()
    assert told == [ValueError]


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


@pytest.mark.skipif(not CAN_FORK, reason='this system has no fork')
def test_the_next_worker_has_the_modules_and_the_types_that_one_has_loaded(monkeypatch: pytest.MonkeyPatch) -> None:
    name, module = 'shape_msgs/msg/Plane', 'edulaunch.engine.recording.trajectory'
    monkeypatch.delitem(sys.modules, module, raising=False)
    monkeypatch.setattr('threading.active_count', lambda: 1)  # what pytest has besides cannot be in the middle of anything
    registry = Registry([underlay_registry().roots[0]])
    monkeypatch.setattr('edulaunch.engine.interfaces.registry.underlay_registry', lambda: registry)

    def known() -> tuple[bool, bool]:
        return name in [cls.TYPE for cls in registry.classes()], module in sys.modules

    def load() -> tuple[bool, bool]:
        before = known()
        registry.get(name)
        import_module(module)
        return before

    assert in_worker(load) == [False, False]
    assert known() == (False, False)  # a single submission needs no other worker
    assert in_worker(load) == [True, True]
    assert known() == (True, True)
