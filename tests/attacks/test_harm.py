"""What one submission could do to the computer and to the class: use up threads and memory, or take a name that results need.

As root and as an ordinary user without capabilities.
"""

from __future__ import annotations

import csv
import json
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from tempfile import TemporaryDirectory

import pytest

from tests.attacks.test_reach import CIRCLE, command
from tests.attacks.test_reach import pytestmark as on_this_system

pytestmark = on_this_system
SOLUTION = CIRCLE.with_name('static_frame.launch.py')
THREADS = """
import ctypes
lib, attributes, thread, made = ctypes.CDLL(None), ctypes.create_string_buffer(64), ctypes.c_ulong(), 0
lib.pthread_attr_init(attributes)
lib.pthread_attr_setstacksize(attributes, ctypes.c_size_t(16384))
while made < 20000 and lib.pthread_create(ctypes.byref(thread), attributes, lib.pause, None) == 0:
    made += 1
raise ValueError(f'{made} threads')
"""
FILL = """
import ctypes, posix, socket
def fill():
    held = []
    while True:
        try:
            pair = socket.socketpair()
        except OSError:
            return held
        held += pair
for number in range(55):
    if posix.fork() == 0:
        held = fill()
        break
ctypes.CDLL(None).pause()
"""
BUFFERS = f"""
import ctypes, subprocess
program = subprocess.Popen(['/usr/bin/env', 'python3', '-c', {FILL!r}])
ctypes.CDLL(None).sleep(150)
raise ValueError('all of it is held')
"""
CUT = {
    'threads': (THREADS, 'the run started too many programs'),
    'buffers of sockets': (BUFFERS, 'the run needed more than 2048 MiB of memory'),
}


@pytest.fixture
def folder() -> Iterator[Path]:
    """A folder that everybody can enter, which pytest's own is not."""
    with TemporaryDirectory(prefix='edulaunch-harm-') as place:
        (Path(place) / 'out').mkdir()
        Path(place).chmod(0o755)
        (Path(place) / 'out').chmod(0o777)
        yield Path(place)


@pytest.mark.parametrize('who', ['as we are', 'as somebody without any right'])
@pytest.mark.parametrize('name', CUT)
def test_there_is_an_end_to_it(folder: Path, name: str, who: str) -> None:
    code, reason = CUT[name]
    (folder / 'circle.launch.py').write_text(CIRCLE.read_text() + code)
    start, environment = command(who)
    words = [
        *start,
        str(folder / 'circle.launch.py'),
        '--seed',
        '7',
        '--limit',
        '200',
        '--json',
        str(folder / 'out' / 'report.json'),
    ]
    done = subprocess.run(words, env=environment, cwd='/', capture_output=True, text=True)
    assert (folder / 'out' / 'report.json').exists(), done.stdout + done.stderr
    report = json.loads((folder / 'out' / 'report.json').read_text())
    assert report['points']['earned'] == 0
    assert {scenario['text'] for scenario in report['scenarios']} == {reason}


def test_a_name_that_results_need_costs_nobody_a_table(tmp_path: Path) -> None:
    names = ['anna', 'teacher.csv', 'index.html', 'Index.HTML', 'students', '=1+1']
    for name in names:
        (tmp_path / 'class' / name).mkdir(parents=True)
        (tmp_path / 'class' / name / SOLUTION.name).write_text(SOLUTION.read_text())
    words = ['batch', str(tmp_path / 'class'), '--csv', str(tmp_path / 'marks.csv'), '--html', str(tmp_path / 'pages')]
    done = subprocess.run([sys.executable, '-m', 'edugrade', *words], capture_output=True, text=True, cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    with open(tmp_path / 'marks.csv', newline='') as file:
        rows = {row['student']: row['earned'] for row in csv.DictReader(file)}
    assert rows == dict.fromkeys(['anna', 'teacher.csv', 'index.html', 'Index.HTML', 'students', "'=1+1"], '12')
    assert (tmp_path / 'pages' / 'index.html').is_file() and not (tmp_path / 'class.results' / 'teacher.csv').exists()
