"""``edugrade doctor`` proves the confinement of runs by trying forbidden actions in an ordinary run."""

from __future__ import annotations

import json
import os
import re
import socket
import tempfile
from collections.abc import Iterator, Sequence
from typing import Any, NamedTuple

from ..evidence import Scenario
from ..job import Limits
from ..runner import Runner
from ..submission import Submission

# Attacks of a hostile launch file: each line is (layer, attempt, code that raises an exception when the sandbox refuses it). The
# code can use `settings`.
_ATTEMPTS = (
    ('descriptors', "use the grader's open files", 'next(number for number in range(5, 200) if is_readable(number))'),
    ('files', 'read a file beside the submission', 'posix.open(settings["secret"], 0)'),
    ('files', 'list the folder of the submission', 'posix.listdir(settings["folder"])'),
    ('files', 'read a rubric', 'posix.open(settings["rubric"], 0)'),
    ('files', 'write beside the submission', 'posix.open(settings["written"], 65)'),
    ('files', 'change its own text', 'posix.open(settings["file"], 1)'),
    ('files', 'change the mode of a file beside the submission', 'posix.chmod(settings["secret"], 0)'),
    ('files', 'change the times of the submission', 'posix.utime(settings["file"])'),
    ('files', 'change the mode of a device', 'posix.chmod("/dev/null", 0o666)'),
    ('files', 'change the mode of what is open', 'posix.fchmod(0, 0o666)'),
    ('view', 'see the size of a file beside the submission', 'posix.stat(settings["secret"])'),
    ('view', 'see that there is a rubric', 'posix.stat(settings["rubric"])'),
    ('network', 'connect to a server on this machine', '_socket.socket(2, 1).connect(("127.0.0.1", settings["port"]))'),
    ('network', 'send a datagram', '_socket.socket(2, 2).sendto(b"x", ("127.0.0.1", settings["port"]))'),
    ('network', 'connect to a socket in the file system', '_socket.socket(1, 1).connect(settings["socket"])'),
    ('network', 'send to a socket in the file system', '_socket.socketpair(1, 2)[0].sendto(b"x", settings["letters"])'),
    ('signals', 'signal the grader', 'posix.kill(settings["pid"], 0)'),
    ('signals', 'signal the process that started it', 'posix.kill(posix.getppid(), 0)'),
    ('processes', "read the grader's environment", 'posix.open(f"/proc/{settings[\'pid\']}/environ", 0)'),
    ('processes', 'look into the process that started it', 'refused(lib.ptrace(0x4206, posix.getppid(), 0, 0))'),
    ('processes', 'make a world of its own (a user namespace)', 'refused(lib.unshare(0x10000000))'),
    ('processes', 'choose its own processors', 'posix.sched_setaffinity(0, posix.sched_getaffinity(0))'),
    ('processes', 'keep files in memory', 'posix.memfd_create("x")'),
    ('privileges', 'become somebody else', 'posix.setuid(settings["other"])'),
    ('privileges', 'give a file to somebody else', 'posix.chown("own", settings["other"], settings["other"])'),
    ('privileges', 'raise its own limits', 'resource.setrlimit(resource.RLIMIT_AS, (-1, -1))'),
    ('environment', 'find a token in its environment', 'posix.environ[b"EDUGRADE_DOCTOR_TOKEN"]'),
)
_PROBE = """
import json, posix, resource, _socket, ctypes
settings = json.loads(%r)
lib = ctypes.CDLL(None, use_errno=True)
posix.close(posix.open("own", 65, 0o600))
heard, told = posix.pipe()
if posix.fork() == 0:
    posix.setsid()
    if posix.fork():
        posix._exit(0)
    posix.write(told, b"%%d" %% posix.getpid())
    while True:
        pass
daemon = int(posix.read(heard, 20))
posix.close(heard)
posix.close(told)


def refused(result):
    if result < 0:
        raise OSError(ctypes.get_errno(), "refused")


def is_readable(number):
    try:
        return posix.read(number, 0) == b""
    except OSError:
        return False


found = []
for code in settings["attempts"]:
    try:
        eval(code)
        found.append(None)
    except Exception as error:
        found.append(type(error).__name__)
raise ValueError("<<<" + json.dumps([daemon, *found]) + ">>>")
"""


class Finding(NamedTuple):
    """The result of one attempt: whether the layer prevented the action, and how the attempt ended."""

    layer: str
    attempt: str
    held: bool
    detail: str


def examine(limits: Limits | None = None) -> Iterator[Finding]:
    """Try each forbidden action once in a confined run, and yield the results."""
    with tempfile.TemporaryDirectory(prefix='edugrade-doctor-') as folder, socket.socket() as server:
        server.bind(('127.0.0.1', 0))
        server.listen()
        with socket.socket(socket.AF_UNIX) as local, socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM) as letters:
            letters.bind(os.path.join(folder, 'd'))
            local.bind(os.path.join(folder, 's'))
            local.listen()
            settings = _settings(folder, server.getsockname()[1])
            with open(settings['file'], 'w', encoding='utf-8') as file:
                file.write(_PROBE % json.dumps(settings))
            yield from _run(settings, limits or Limits())


def _settings(folder: str, port: int) -> dict[str, Any]:

    secret = os.path.join(folder, 'other_student.launch.py')
    with open(secret, 'w', encoding='utf-8') as file:
        file.write('# secret')
    return {
        'folder': folder,
        'file': os.path.join(folder, 'probe.launch.py'),
        'secret': secret,
        'written': os.path.join(folder, 'written'),
        'socket': os.path.join(folder, 's'),
        'letters': os.path.join(folder, 'd'),
        'rubric': _a_rubric(),
        'port': port,
        'pid': os.getpid(),
        'other': 65534 if os.getuid() != 65534 else 65533,
        'attempts': [code for _, _, code in _ATTEMPTS],
    }


def _a_rubric() -> str:
    """Return an existing rubric, because an attempt to read a missing file would prove nothing."""
    from ..rubrics.catalogue import rubrics_folder

    folder = rubrics_folder()
    return next(os.path.join(folder, name) for name in sorted(os.listdir(folder)) if os.path.isfile(os.path.join(folder, name)))


def _run(settings: dict[str, Any], limits: Limits) -> Iterator[Finding]:
    os.environ['EDUGRADE_DOCTOR_TOKEN'] = 'of a CI server'
    try:
        with Runner(limits, processors=1) as runner:
            (outcome,) = runner.wait(runner.add(Submission(settings['file']), [Scenario('probe', {}, 1.0)]))
            homes = runner.homes()
    finally:
        del os.environ['EDUGRADE_DOCTOR_TOKEN']
    match = re.search(r'<<<(.*?)>>>', outcome.text, re.DOTALL)
    if match is None:
        yield Finding('run', 'launch the attempts', False, outcome.text)
        return
    daemon, *errors = json.loads(match[1])
    for (layer, attempt, _), error in zip(_ATTEMPTS, errors, strict=True):
        yield Finding(layer, attempt, error is not None, error or 'it could')
    alive = _is_alive(daemon)
    yield Finding('processes', 'outlive the run', not alive, 'it still runs' if alive else 'ended')
    left = [home for home in homes if os.path.exists(home)]
    yield Finding('files', 'leave its folder behind', not left, 'it is there' if left else 'removed')


def _is_alive(pid: int) -> bool:
    try:
        os.kill(pid, 0)
    except ProcessLookupError:
        return False
    except PermissionError:
        pass
    return True


def report(findings: list[Finding]) -> str:
    """Return a line for each attempt, and a summary."""
    lines = [f'{"held" if item.held else "NOT HELD":<9}{item.layer:<12}{item.attempt} ({item.detail})' for item in findings]
    bad = sorted({item.layer for item in findings if not item.held})
    last = 'Every attempt was refused.' if not bad else f'A submission on this machine is NOT confined: {", ".join(bad)}.'
    return '\n'.join([*lines, '', last]) + '\n'


def main(words: Sequence[str] = ()) -> int:
    """Run the command. Return 0 if every check passed, and otherwise 1."""
    findings = list(examine())
    print(report(findings), end='')
    return 0 if all(item.held for item in findings) else 1
