"""What a submission can reach beyond its own folder and its own processes: nothing, as root and as somebody without any right.

One launch file attempts all of it and says what came of each attempt.
"""

from __future__ import annotations

import glob
import json
import os
import re
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest
from edugrade.sandbox import landlock, seccomp

pytestmark = [
    pytest.mark.attacks,
    pytest.mark.skipif(
        landlock.version() < 6 or seccomp.filter_program() is None,
        reason='this system lacks Landlock 6, or is of an unknown kind',
    ),
]
ROOT = Path(__file__).resolve().parents[2]
CIRCLE = ROOT / 'solutions' / 'circle.launch.py'
REFUSED = {
    'chmod': 'os.chmod("../b/circle.launch.py", 0)',
    'chmod of itself': 'os.chmod(__file__, 0)',
    'chmod of an open file': 'os.fchmod(os.open(__file__, 0), 0)',
    'chown': 'os.chown(__file__, os.getuid(), os.getgid())',
    'utime': 'os.utime(__file__)',
    'setxattr': 'os.setxattr(__file__, "user.a", b"x")',
    'socket': 'socket.socket()',
    'datagrams': 'socket.socketpair(socket.AF_UNIX, socket.SOCK_DGRAM)',
    'datagrams by another name': 'socket.socketpair(socket.AF_UNIX, socket.SOCK_RAW)',
    'bind': 'socket.socketpair()[0].bind("own")',
    'connect': 'socket.socketpair()[0].connect("own")',
    'an address': 'socket.socketpair()[0].sendto(b"x", "own")',
    'affinity': 'os.sched_setaffinity(0, {0})',
    'priority': 'os.setpriority(os.PRIO_PROCESS, 0, 5)',
    'nice': 'os.nice(1)',
    'ionice': 'checked(lib.syscall(251, 1, 0, 3 << 13))',
    'inotify': 'checked(lib.inotify_init())',
    'memory that is a file': 'os.memfd_create("x")',
    'shared memory': 'checked(lib.shmget(0, 4096, 0o1600))',
    'personality': 'checked(lib.personality(0))',
    'prctl': 'checked(lib.prctl(4, 0, 0, 0, 0))',
    'ioctl': 'checked(lib.ioctl(0, 0x5412, b"x"))',
}
"""Each fails with EPERM."""
HARMLESS = {
    'a pair of sockets': 'socket.socketpair()[0].fileno() > 0',
    'a thread': 'threading.Thread(target=int).start()',
    'a program': 'subprocess.run(["sh", "-c", "echo hi"], capture_output=True).stdout.decode()',
    'a temporary file': 'open(tempfile.mkstemp()[1], "w").write("x")',
    'another Python': 'subprocess.run([sys.executable, "-c", "import asyncio, sqlite3, ssl"], capture_output=True).returncode',
    'how many processors': 'len(os.sched_getaffinity(0)) > 0',
}
UNSEEN = {
    'a neighbour': 'os.stat(settings["neighbour"])',
    'a neighbour by opening': 'os.open(settings["neighbour"], os.O_PATH)',
    'a neighbour by a link': '[os.symlink(settings["neighbour"], "link"), os.stat("link")]',
    'a rubric': 'os.stat(settings["rubric"])',
    'the grader': 'os.stat(settings["grader"])',
    'the solution': 'os.stat(settings["solution"])',
    'shadow': 'os.stat("/etc/shadow")',
    'processes': 'os.stat("/proc/1")',
}
"""Each is not there."""
FULL = {
    'disk': '[open(f"big{number}", "wb").write(bytes(60 << 20)) for number in range(4)]',
    'inodes': '[open(f"small{number}", "w").close() for number in range(6000)]',
}
"""Each ends with ENOSPC, in a file system of the run's own."""
PROBE = """
import ctypes, json, os, socket, subprocess, sys, tempfile, threading
settings = json.loads(%r)
lib = ctypes.CDLL(None, use_errno=True)


def checked(result):
    if result < 0:
        raise OSError(ctypes.get_errno(), 'refused')


found = {}
for name, code in settings['attempts'].items():
    try:
        found[name] = repr(eval(code))[:80]
    except OSError as error:
        found[name] = error.errno
    except BaseException as error:
        found[name] = repr(error)
raise ValueError('<<<' + json.dumps(found) + '>>>')
"""
ORDINARY = ['setpriv', '--reuid=1000', '--regid=1000', '--clear-groups', '--bounding-set=-all', '--inh-caps=-all']
SYSTEM_PYTHON = '/usr/bin/python3'


def command(who: str) -> tuple[list[str], dict[str, str]]:
    """How somebody calls edugrade, and the environment for it."""
    if who == 'as we are':
        return [sys.executable, '-m', 'edugrade'], dict(os.environ)
    packages = [str(ROOT), str(ROOT / 'grader'), *glob.glob(str(ROOT / '.venv/lib/python3*/site-packages'))]
    environment = {'PATH': '/usr/bin:/bin', 'HOME': '/tmp', 'PYTHONDONTWRITEBYTECODE': '1', 'PYTHONPATH': ':'.join(packages)}
    start = [*ORDINARY, SYSTEM_PYTHON, '-m', 'edugrade']
    tried = subprocess.run([*start, '--version'], env=environment, cwd='/', capture_output=True) if os.getuid() == 0 else None
    if tried is None or tried.returncode != 0:
        pytest.skip('only root can become somebody else, who needs a Python that everybody may read')
    return start, environment


@pytest.fixture(scope='module', params=['as we are', 'as somebody without any right'])
def found(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> dict[str, Any]:
    """What came of each attempt, with the report of the run as ``report``."""
    folder = tmp_path_factory.mktemp('reach')
    for place in (folder, *folder.parents[:2]):
        place.chmod(0o755)
    (folder / 'a').mkdir()
    (folder / 'b').mkdir()
    (folder / 'b' / 'circle.launch.py').write_text(CIRCLE.read_text())
    settings = {
        'attempts': {**REFUSED, **HARMLESS, **UNSEEN, **FULL},
        'neighbour': str(folder / 'b' / 'circle.launch.py'),
        'rubric': str(ROOT / 'grader' / 'checks' / 'circle.py'),
        'grader': str(ROOT / 'grader' / 'edugrade' / 'cli.py'),
        'solution': str(CIRCLE),
    }
    (folder / 'a' / 'circle.launch.py').write_text(CIRCLE.read_text() + PROBE % json.dumps(settings))
    start, environment = command(request.param)
    (folder / 'out').mkdir()
    (folder / 'out').chmod(0o777)
    words = [*start, str(folder / 'a' / 'circle.launch.py'), '--seed', '7', '--json', str(folder / 'out' / 'report.json')]
    done = subprocess.run(words, env=environment, cwd='/', capture_output=True, text=True)
    assert (folder / 'out' / 'report.json').exists(), done.stdout + done.stderr
    report = json.loads((folder / 'out' / 'report.json').read_text())
    if report['sandbox'].get('view') != 'held':
        pytest.skip(f'this system has no view of its own for a run: {report["sandbox"]}')
    text = report['scenarios'][0]['text']
    inner = re.search(r'<<<(.*?)>>>', text, re.DOTALL)
    assert inner is not None, text
    return {**json.loads(inner[1]), 'report': report, 'folder': folder}


@pytest.mark.parametrize('name', REFUSED)
def test_it_is_refused(found: dict[str, Any], name: str) -> None:
    assert found[name] == 1


@pytest.mark.parametrize('name', HARMLESS)
def test_it_is_allowed(found: dict[str, Any], name: str) -> None:
    assert found[name] in ('True', 'None', "'hi\\n'", '1', '0')


@pytest.mark.parametrize('name', UNSEEN)
def test_it_is_not_there(found: dict[str, Any], name: str) -> None:
    assert found[name] == 2


@pytest.mark.parametrize('name', FULL)
def test_there_is_an_end_to_it(found: dict[str, Any], name: str) -> None:
    assert found[name] == 28


def test_the_report_names_the_calls(found: dict[str, Any]) -> None:
    (scenario, *_) = found['report']['scenarios']
    assert {'chmod', 'fchmod', 'chown', 'utimensat', 'setxattr', 'socket', 'bind', 'sendto'} <= set(scenario['refused_calls'])
    assert 'A graded run may not make the system call chmod or ' in scenario['text']


def test_the_neighbour_is_as_it_was(found: dict[str, Any]) -> None:
    path = found['folder'] / 'b' / 'circle.launch.py'
    assert (path.stat().st_mode & 0o777, path.read_text()) == (0o644, CIRCLE.read_text())
