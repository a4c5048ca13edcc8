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
    'chown': 'os.chown(__file__, os.getuid(), os.getgid())',
    'setxattr': 'os.setxattr(__file__, "user.a", b"x")',
    'socket': 'socket.socket()',
    'datagrams': 'socket.socketpair(socket.AF_UNIX, socket.SOCK_DGRAM)',
    'datagrams by another name': 'socket.socketpair(socket.AF_UNIX, socket.SOCK_RAW)',
    'bind': 'socket.socketpair()[0].bind("own")',
    'connect': 'socket.socketpair()[0].connect("own")',
    'an address': 'socket.socketpair()[0].sendto(b"x", "own")',
    'large buffers': 'socket.socketpair()[0].setsockopt(socket.SOL_SOCKET, socket.SO_SNDBUF, 1 << 20)',
    'large buffers at the other end': 'socket.socketpair()[0].setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 1 << 20)',
    'affinity': 'os.sched_setaffinity(0, {0})',
    'priority': 'os.setpriority(os.PRIO_PROCESS, 0, 5)',
    'nice': 'os.nice(1)',
    'ionice': 'checked(lib.syscall(251, 1, 0, 3 << 13))',
    'inotify': 'checked(lib.inotify_init())',
    'memory that is a file': 'os.memfd_create("x")',
    'secret memory': 'checked(lib.syscall(447, 0))',
    'ptrace of its parent': 'checked(lib.ptrace(0x4206, posix.getppid(), 0, 0))',
    'ptrace of itself': 'checked(lib.ptrace(0, 0, 0, 0))',
    'memory of its parent': 'checked(lib.syscall(310, posix.getppid(), None, 0, None, 0, 0))',
    'memory of its parent, written': 'checked(lib.syscall(311, posix.getppid(), None, 0, None, 0, 0))',
    'descriptors of its parent': 'checked(lib.syscall(438, os.pidfd_open(posix.getppid()), 0, 0))',
    'comparing with its parent': 'checked(lib.syscall(312, posix.getppid(), os.getpid(), 0, 0, 0))',
    'advice on memory of its parent': 'checked(lib.syscall(440, os.pidfd_open(posix.getppid()), None, 0, 4, 0))',
    'limits of its parent': 'resource.prlimit(posix.getppid(), resource.RLIMIT_CPU, (1, 1))',
    'inotify by another name': 'checked(lib.inotify_init1(0))',
    'a lease of a file': 'fcntl.fcntl(os.open(__file__, 0), fcntl.F_SETLEASE, fcntl.F_RDLCK)',
    'notes about a folder': 'fcntl.fcntl(os.open("/usr", 0), fcntl.F_NOTIFY, 1)',
    'signals about a file to its parent': 'fcntl.fcntl(socket.socketpair()[0], fcntl.F_SETOWN, posix.getppid())',
    'a lock on a file that all may read': 'fcntl.flock(os.open(os.__file__, 0), fcntl.LOCK_EX)',
    'a lock on its own text': 'fcntl.flock(os.open(__file__, 0), fcntl.LOCK_SH | fcntl.LOCK_NB)',
    'who holds a lock': 'fcntl.fcntl(os.open(os.__file__, 0), fcntl.F_GETLK, struct.pack("hhqqi", fcntl.F_WRLCK, 0, 0, 0, 0))',
    'who holds a lock by another name': 'fcntl.fcntl(os.open(os.__file__, 0), 36, struct.pack("hhqqi", 1, 0, 0, 0, 0))',
    'large pipes': 'fcntl.fcntl(os.pipe()[0], 1031, 1 << 20)',
    'fanotify': 'checked(lib.syscall(300, 0, 0))',
    'perf events': 'checked(lib.syscall(298, None, 0, -1, -1, 0))',
    'shared memory': 'checked(lib.shmget(0, 4096, 0o1600))',
    'personality': 'checked(lib.personality(0))',
    'prctl': 'checked(lib.prctl(4, 0, 0, 0, 0))',
    'ioctl': 'checked(lib.ioctl(0, 0x5412, b"x"))',
}
"""Each fails with EPERM."""
READ_ONLY = {  # with the modes that they have: an attempt that succeeds does no harm
    'chmod of itself': 'os.chmod(__file__, 0)',
    'chmod of an open file': 'os.fchmod(os.open(__file__, 0), 0)',
    'chmod by a newer call': 'checked(lib.syscall(452, -100, __file__.encode(), 0, 0))',
    'chmod of its input': 'os.fchmod(0, 0o666)',
    'chmod of a device': 'os.chmod("/dev/null", 0o666)',
    'chmod of a device that is open': 'os.fchmod(os.open("/dev/null", 2), 0o666)',
    'chmod of Python': 'os.chmod(os.path.realpath(sys.executable), 0o755)',
    'chmod of a folder above': 'os.chmod(os.path.dirname(os.getcwd()), 0o755)',
    'chmod of the root': 'os.chmod("/", 0o755)',
    'utime of itself': 'os.utime(__file__)',
    'utime of a device': 'os.utime("/dev/null")',
    'utime of a package': 'os.utime(os.__file__)',
}
"""Each fails with EROFS: nothing but the run's own folder can be changed."""
OWN = {
    'chmod': '[open("own", "w").close(), os.chmod("own", 0o600), os.stat("own").st_mode & 0o777 == 0o600][-1]',
    'copy': 'shutil.copy(__file__, "copied") == "copied"',
    'copy with its times': 'shutil.copy2(__file__, "copied2") == "copied2" and os.stat("copied2").st_mtime_ns > 0',
    'a tree': '[os.makedirs("tree/a"), shutil.copytree("tree", "tree2"), os.path.isdir("tree2/a")][-1]',
    'a database': '[sqlite3.connect("own.db").executescript("create table a(b); insert into a values (1)"), os.path.getsize("own.db") > 0][-1]',
    'a lock': '[fcntl.lockf(open("locked", "w"), fcntl.LOCK_EX | fcntl.LOCK_NB), True][-1]',
    'times': '[open("timed", "w").close(), os.utime("timed", (1, 1)), os.stat("timed").st_mtime == 1][-1]',
}
"""Each is allowed in the run's own folder."""
HARMLESS = {
    'a pair of sockets': 'socket.socketpair()[0].fileno() > 0',
    'a timeout': 'socket.socketpair()[0].setsockopt(socket.SOL_SOCKET, socket.SO_RCVTIMEO, bytes(16))',
    'a thread': 'threading.Thread(target=int).start()',
    'a program': 'subprocess.run(["sh", "-c", "echo hi"], capture_output=True).stdout.decode()',
    'a temporary file': 'open(tempfile.mkstemp()[1], "w").write("x")',
    'another Python': 'subprocess.run([sys.executable, "-c", "import asyncio, sqlite3, ssl"], capture_output=True).returncode',
    'how many processors': 'len(os.sched_getaffinity(0)) > 0',
}
UNSEEN = {
    'the mode of a neighbour': 'os.chmod(settings["neighbour"], 0)',
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
FEW = {
    'timers': '[checked(lib.timer_create(1, None, ctypes.byref(ctypes.c_void_p()))) for number in range(20000)]',
    'descriptors': 'dup_all()',
}
"""Each has an end, long before others of this user find none."""
NULL = {
    'the user': 'os.getuid()',
    'the null device': '(os.stat("/dev/null").st_dev, os.stat("/dev/null").st_ino)',
    'what the null device does': '(os.write(os.open("/dev/null", os.O_RDWR), b"abc"), os.read(os.open("/dev/null", os.O_RDWR), 9))',
}
ENDS = (11, 24)
PROBE = """
import ctypes, fcntl, json, os, posix, resource, shutil, socket, sqlite3, struct, subprocess, sys, tempfile, threading
settings = json.loads(%r)
lib = ctypes.CDLL(None, use_errno=True)


def checked(result):
    if result < 0:
        raise OSError(ctypes.get_errno(), 'refused')


def dup_all():
    held = []
    try:
        while len(held) < 20000:
            held.append(os.dup(1))
    finally:
        for each in held:
            os.close(each)


found = {}
for name, code in settings['attempts'].items():
    try:
        found[name] = repr(eval(code))[:80]
    except OSError as error:
        found[name] = error.errno
    except BaseException as error:
        found[name] = repr(error)
for name in os.listdir():  # what comes next may need a temporary file
    if name.startswith(('big', 'small')):
        os.remove(name)
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
        'attempts': {**REFUSED, **READ_ONLY, **OWN, **HARMLESS, **UNSEEN, **FULL, **FEW, **NULL},
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


@pytest.mark.parametrize('name', READ_ONLY)
def test_it_is_read_only(found: dict[str, Any], name: str) -> None:
    assert found[name] == 30


@pytest.mark.parametrize('name', OWN)
def test_its_own_files_are_its_own(found: dict[str, Any], name: str) -> None:
    assert found[name] == 'True'


@pytest.mark.parametrize('name', HARMLESS)
def test_it_is_allowed(found: dict[str, Any], name: str) -> None:
    assert found[name] in ('True', 'None', "'hi\\n'", '1', '0')


@pytest.mark.parametrize('name', UNSEEN)
def test_it_is_not_there(found: dict[str, Any], name: str) -> None:
    assert found[name] == 2


@pytest.mark.parametrize('name', FULL)
def test_there_is_an_end_to_it(found: dict[str, Any], name: str) -> None:
    assert found[name] == 28


@pytest.mark.parametrize('name', FEW)
def test_there_are_few_of_it(found: dict[str, Any], name: str) -> None:
    assert found[name] in ENDS


def test_root_gives_each_run_its_own_devices(found: dict[str, Any]) -> None:
    """Else a run could lock a part of /dev/null, and the next one would see it."""
    who = os.stat('/dev/null')
    is_own = found['the null device'] != repr((who.st_dev, who.st_ino))
    assert is_own == (found['the user'] == '0'), found['the null device']
    assert found['what the null device does'] == "(3, b'')"


def test_the_report_names_the_calls(found: dict[str, Any]) -> None:
    (scenario, *_) = found['report']['scenarios']
    assert {'chown', 'setxattr', 'socket', 'bind', 'sendto', 'ptrace'} <= set(scenario['refused_calls'])
    assert 'The sandbox does not allow the system call chown or ' in scenario['text']


def test_the_neighbour_is_as_it_was(found: dict[str, Any]) -> None:
    path = found['folder'] / 'b' / 'circle.launch.py'
    assert (path.stat().st_mode & 0o777, path.read_text()) == (0o644, CIRCLE.read_text())
