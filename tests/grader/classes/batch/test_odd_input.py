"""Whatever lies in a class's folder ends in a verdict, and costs nobody else a mark."""

from __future__ import annotations

import json
import os
import socket
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from edugrade.cli import main
from edugrade.sandbox.remove_tree import remove_tree

SOLUTION = (Path(__file__).parents[4] / 'solutions' / 'static_frame.launch.py').read_text()
NAME = 'static_frame.launch.py'
SLOW_TEXT = (
    'class Slow(Exception):\n    def __str__(self):\n        while True:\n            pass\n\n\n'
    'def generate_launch_description():\n    raise Slow()\n'
)
SLEEPER = (
    f'import subprocess, sys\nsubprocess.Popen([sys.executable, "-c", "import time; time.sleep({os.getpid()}600)"])\n' + SOLUTION
)


def a_socket(folder: Path) -> None:
    before = os.getcwd()
    os.chdir(folder)
    try:
        with socket.socket(socket.AF_UNIX) as end:
            end.bind(NAME)
    finally:
        os.chdir(before)


def deep(folder: Path) -> None:
    before = os.getcwd()
    os.chdir(folder)
    try:
        for _ in range(1100):
            os.mkdir('deep')
            os.chdir('deep')
        Path(NAME).write_text(SOLUTION)
    finally:
        os.chdir(before)


def unreadable(folder: Path) -> None:
    (folder / NAME).write_text(SOLUTION)
    (folder / NAME).chmod(0)


def package_of_pipes(folder: Path) -> None:
    (folder / 'launch').mkdir()
    for name in ('package.xml', 'setup.py', f'launch/{NAME}'):
        os.mkfifo(folder / name)


ODD: dict[str, Callable[[Path], object]] = {
    'pipe': lambda folder: os.mkfifo(folder / NAME),
    'socket': a_socket,
    'device': lambda folder: (folder / NAME).symlink_to('/dev/zero'),
    'dead_link': lambda folder: (folder / NAME).symlink_to('nowhere'),
    'loop': lambda folder: (folder / NAME).symlink_to(NAME),
    'folder': lambda folder: (folder / NAME).mkdir(),
    'deep': deep,
    'unreadable': unreadable,
    'package_of_pipes': package_of_pipes,
    'huge': lambda folder: (folder / NAME).write_bytes(b'#' * 2_000_000),
    'zeros': lambda folder: (folder / NAME).write_bytes(bytes(1000)),
    'half_a_character': lambda folder: (folder / NAME).write_bytes(b'\xff\xfe' + SOLUTION.encode()),
    'digits': lambda folder: (folder / NAME).write_text(f'{SOLUTION}\n# TODO {"9" * 5000}\n'),
    'slow_error': lambda folder: (folder / NAME).write_text(SLOW_TEXT),
    'sleeper': lambda folder: (folder / NAME).write_text(SLEEPER),
    'bytes_name': lambda folder: Path(os.fsdecode(os.fsencode(folder) + b'/\xff' + NAME.encode())).write_text('x'),
    'empty_zip': lambda folder: (folder / 'work.zip').write_bytes(b'PK\x05\x06' + bytes(18)),
    'no_zip': lambda folder: (folder / 'work.zip').write_bytes(b''),
}


@pytest.fixture
def group(tmp_path: Path) -> Iterator[Path]:
    """A class of odd things; removed here, for it is deeper than others can remove."""
    for name, make in ODD.items():
        (tmp_path / 'class' / name).mkdir(parents=True)
        make(tmp_path / 'class' / name)
    (tmp_path / 'class' / 'zoe').mkdir()
    (tmp_path / 'class' / 'zoe' / NAME).write_text(SOLUTION)
    yield tmp_path / 'class'
    remove_tree(str(tmp_path / 'class'))
    assert not (tmp_path / 'class').exists()


@pytest.mark.whole
@pytest.mark.filterwarnings('ignore::ResourceWarning')
def test_everybody_has_a_verdict_and_the_last_one_a_mark(group: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / 'private').mkdir()
    monkeypatch.setenv('TMPDIR', str(tmp_path / 'private'))
    words = ['--csv', str(tmp_path / 'marks.csv'), '--html', str(tmp_path / 'pages'), '--junit', str(tmp_path / 'junit.xml')]
    assert main(['batch', str(group), '--limit', '5', *words]) == 0
    found = {}
    for path in (tmp_path / 'class.results').rglob('*.json'):
        result = json.loads(path.read_text())
        found[result['student']] = result
    assert set(found) == {*ODD, 'zoe'}
    assert {result['exit_code'] for result in found.values()} <= {0, 1, 2}
    assert found['zoe']['points']['earned'] == found['digits']['points']['earned'] == 12
    without = {name for name, result in found.items() if 'refused' in result}
    expected = {
        'pipe',
        'socket',
        'device',
        'dead_link',
        'loop',
        'folder',
        'deep',
        'package_of_pipes',
        'huge',
        'bytes_name',
        'empty_zip',
        'no_zip',
    }
    assert without - {'unreadable'} == expected
    assert os.listdir(tmp_path / 'private') == []
    assert f'time.sleep({os.getpid()}600)'.encode() not in commands_that_run()


def commands_that_run() -> bytes:
    """The command lines of every process, where the system tells them."""
    texts = []
    for folder in Path('/proc').iterdir() if Path('/proc').is_dir() else ():
        try:
            texts.append((folder / 'cmdline').read_bytes())
        except OSError:
            continue
    return b'\n'.join(texts)
