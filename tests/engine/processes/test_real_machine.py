"""A program that reads the real machine is named, with what it used."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

import edulaunch
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
        'import multiprocessing\nmultiprocessing.cpu_count()',
    ],
)
def test_what_is_simulated_is_nobodys_business(world: Any, text: str) -> None:
    assert notes(world, text) == []


def test_a_recording_says_so_wherever_the_machine_was_read(tmp_path: Path) -> None:
    (tmp_path / 'reads.py').write_text('import os\nos.system("true")\nwith open("/proc/loadavg"): pass\n')
    (tmp_path / 'a.launch.py').write_text(
        'from launch import LaunchDescription\nfrom launch.actions import ExecuteProcess\n'
        'def generate_launch_description():\n'
        f'    return LaunchDescription([ExecuteProcess(cmd=["python3", "{tmp_path}/reads.py"], name="monitor")])\n'
    )
    recording = edulaunch.run(tmp_path / 'a.launch.py', duration_s=1.0)
    assert recording.not_repeatable == [
        "monitor-1 ran 'true', which is a real program",
        'monitor-1 used /proc/loadavg: this run cannot repeat exactly',
    ]
    assert recording.warnings == []
