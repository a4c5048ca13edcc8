"""A program that reads the real machine is named, with what it used."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

import edulaunch
from edulaunch.engine.processes.real_machine import with_real_paths
from edulaunch.engine.recording import Recorder, Recording


def notes(world: Any, text: str) -> list[str]:
    """Why the run of a script does not repeat."""
    recorder = Recorder(world.sim)
    world.host.tracer = world.host.graph.tracer = recorder
    world.run(text)
    found: Recording = recorder.recording()
    return [
        note.removeprefix('program-1 used ').removesuffix(': this run cannot repeat exactly') for note in found.not_repeatable
    ]


@pytest.mark.parametrize(
    'text, used',
    [
        ('import psutil_', []),
        ('import os\nos.getloadavg()', ['os.getloadavg']),
        ('print(id(notes := []))', ['builtins.id']),
        ('hash(object())', ['hash()']),
        ('import os\nos.umask(os.umask(0o22))', ['os.umask']),
        ('import os.path\nos.path.getmtime("/dev/null")', ['os.path.getmtime']),
        ('import os\nprint(os.stat("/dev/null").st_mtime)', ['st_mtime of a file']),
        (
            'import pathlib\nsorted([pathlib.Path("/dev/null")], key=lambda path: path.stat().st_ctime_ns)',
            ['st_ctime_ns of a file'],
        ),
        ('import os\nfor each in os.scandir("/dev/fd"):\n    each.stat().st_atime\n    break', ['st_atime of a file', '/dev/fd']),
        ('import os, shutil\nos.stat("/dev/null").st_size, shutil.which("sh")', []),
        ('import copy\ncopy.deepcopy([[]])', []),
        ('import platform\nplatform.node()', ['the module platform']),
        ('for _ in "ab":\n    with open("/proc/uptime"): pass', ['/proc/uptime']),
        ('import pathlib\npathlib.Path("/proc/stat").read_text()', ['/proc/stat (pathlib)']),
        ('import os\nos.listdir("/sys/class")', ['/sys/class']),
        ('import os\nos.environ["USER"], os.getenv("HOME"), os.environ.get("NOBODY")', ['$USER']),
        ('import getpass\ngetpass.getuser()', ['$LOGNAME']),
        ('import socket\nsocket.gethostname()', ['socket.gethostname']),
        ('import socket\ns = socket.socket()\ns.bind(("127.0.0.1", 0))\ns.close()', ['socket.bind']),
        (
            'import http.client\ntry:\n    http.client.HTTPConnection("127.0.0.1", 1).connect()\nexcept OSError: pass',
            ['socket.getaddrinfo (http)', 'socket.connect (http)'],
        ),
    ],
)
def test_what_was_used_is_named(world: Any, text: str, used: list[str]) -> None:
    assert notes(world, text) == used


@pytest.mark.parametrize(
    'text',
    [
        'import socket, logging, asyncio, json, numpy, tempfile',
        'with open("/dev/null", "w") as file: file.write("x")',
        'import os, time, random, uuid, threading\nos.urandom(4), os.getpid(), time.time(), random.random(), uuid.uuid4()',
        'import asyncio\nasyncio.run(asyncio.sleep(1))',
        'import concurrent.futures\nwith concurrent.futures.ThreadPoolExecutor() as pool:\n    pool.submit(print, 1).result()',
        'print(object())\nhash((1, 2.5))\nclass A:\n    def __hash__(self): return hash("a")\nhash(A())',
        'import multiprocessing\nmultiprocessing.cpu_count()',
    ],
)
def test_what_is_simulated_is_nobodys_business(world: Any, text: str) -> None:
    assert notes(world, text) == []


def test_hashes_and_sets_of_strings_are_named_where_the_hash_seed_is_not_fixed(
    world: Any, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    script = tmp_path / 'program.py'
    script.write_text('for name in {"a", "b"}: pass\nhash("a"), hash(("a",)), hash(1)\n')
    for is_random, used in ((True, ['the order of a set (PYTHONHASHSEED is not set) in program.py:1', 'hash()']), (False, [])):
        monkeypatch.setattr('edulaunch.engine.processes.real_machine.has_random_hashes', lambda is_random=is_random: is_random)
        recording = edulaunch.run(launch_of(tmp_path, script), duration_s=1.0)
        assert [note.split(' used ')[1].split(': this')[0] for note in recording.not_repeatable] == used


def test_temporary_files_and_addresses_of_objects_do_not_change_a_digest(tmp_path: Path) -> None:
    script = tmp_path / 'program.py'
    script.write_text(
        'import tempfile\nprint(tempfile.mkdtemp(prefix="my"), tempfile.NamedTemporaryFile(delete=False, suffix=".yaml").name)\n'
        'class Robot: pass\nprint(robots := [Robot() for _ in range(3)])\n'
    )
    first, second = (edulaunch.run(launch_of(tmp_path, script), duration_s=1.0) for _ in range(2))
    assert first.output != second.output, 'the names of the first run are taken'
    assert first.digest() == second.digest() and first.not_repeatable == []


def launch_of(folder: Path, script: Path) -> Path:
    """Write a launch file that runs a script."""
    (folder / 'a.launch.py').write_text(
        'from launch import LaunchDescription\nfrom launch.actions import ExecuteProcess\n'
        'def generate_launch_description():\n'
        f'    return LaunchDescription([ExecuteProcess(cmd=["python3", "{script}"], name="monitor", output="screen")])\n'
    )
    return folder / 'a.launch.py'


def test_a_recording_says_so_wherever_the_machine_was_read(tmp_path: Path) -> None:
    (tmp_path / 'reads.py').write_text('import os\nos.system("true")\nwith open("/proc/loadavg"): pass\n')
    recording = edulaunch.run(launch_of(tmp_path, tmp_path / 'reads.py'), duration_s=1.0)
    assert recording.not_repeatable == [
        "monitor-1 ran 'true', which is a real program",
        'monitor-1 used /proc/loadavg: this run cannot repeat exactly',
    ]
    assert recording.warnings == []


def test_a_root_is_followed_by_its_real_path_and_folders_of_the_system_are_left_out(tmp_path: Path) -> None:
    (tmp_path / 'real').mkdir()
    (tmp_path / 'link').symlink_to('real')
    roots = [(str(tmp_path / 'link'), '@tmp'), ('/usr', '@stdlib'), (str(tmp_path / 'real'), '@cwd')]
    real = str((tmp_path / 'real').resolve())
    assert list(with_real_paths(roots)) == [[str(tmp_path / 'link'), '@tmp'], [real, '@tmp'], [real, '@cwd']]
