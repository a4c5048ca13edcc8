"""A fault of the computer is never booked on a student: whichever call fails, there is the right outcome or no mark."""

from __future__ import annotations

import builtins
import errno
import os
import re
import socket
import struct
import threading
from collections.abc import Callable, Iterator
from functools import partial
from importlib.util import find_spec
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest
from edugrade import Scenario
from edugrade.cli import main
from edugrade.evidence import Outcome
from edugrade.faults import REPAIR, ComputerFault, fault_here, fault_of, looks_like_one, missing_for, words_of
from edugrade.job import Limits
from edugrade.runner import Runner
from edugrade.sandbox.confine import _tried
from edugrade.submission import Submission

from edulaunch.engine.recording import Recording
from edulaunch.engine.recording.records import LogRecord
from tests.grader import faulty_starter

ROOT = Path(__file__).resolve().parents[2]
NUMBERS = (errno.ENOSPC, errno.ENOMEM, errno.EMFILE, errno.EIO, errno.EROFS, errno.EAGAIN)
START = threading.Thread.start
STEP = 1 if os.environ.get('EDULAUNCH_THOROUGH') else 5
"""Of the calls of a run each one fails in its turn, or each fifth one."""


def test_errors_of_the_computer_have_sentences_and_others_have_none() -> None:
    assert fault_of(OSError(errno.ENOSPC, 'x', '/tmp/a')) == 'the disk is full: /tmp/a'
    assert fault_of(MemoryError()) == 'this computer has no memory left'
    assert fault_of(OSError(errno.ENOENT, 'x')) is None
    assert words_of(ComputerFault('the disk is full'))[0] == 'not graded: the disk is full'
    assert words_of(KeyError(1))[0] == 'the grader broke: KeyError: 1'


def test_only_numbers_of_such_errors_are_looked_into() -> None:
    scenario = Scenario('s')
    assert looks_like_one(Outcome(scenario, 'unusable', text='OSError: [Errno 28] No space left on device'))
    assert looks_like_one(Outcome(scenario, 'unusable', text='ImportError: math.so: failed to map segment from shared object'))
    assert looks_like_one(Outcome(scenario, 'unusable', text="RuntimeError: can't start new thread"))
    assert looks_like_one(
        Outcome(scenario, 'stopped', text="FileNotFoundError: [Errno 2] No usable temporary directory found in ['/tmp']")
    )
    assert not looks_like_one(Outcome(scenario, 'unusable', text='FileNotFoundError: [Errno 2] No such file'))
    assert not looks_like_one(Outcome(scenario, 'stopped', text='it did not finish'))


@pytest.mark.parametrize(
    ('process', 'message', 'is_one'),
    [
        ('launch', 'exception occurred while executing process:\nOSError: [Errno 12] Cannot allocate memory', True),
        ('launch', 'exception occurred while executing process:\nFileNotFoundError: [Errno 2] No such file', False),
        ('turtle-1', 'exception occurred while executing process:\nOSError: [Errno 12] Cannot allocate memory', False),
    ],
)
def test_a_program_that_launch_could_not_start_is_looked_into(process: str, message: str, is_one: bool) -> None:
    recording: Any = SimpleNamespace(processes=[], logs=[LogRecord(0.0, process, 'turtle-1', 40, message)])
    assert looks_like_one(Outcome(Scenario('s'), 'recorded', recording=recording)) is is_one


@pytest.mark.processes
def test_the_computer_is_tried(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    assert fault_here(str(tmp_path)) is None
    assert fault_here(str(tmp_path / 'none')) == 'the directory for temporary files does not exist'

    def no_process() -> int:
        raise OSError(errno.EAGAIN, 'x')

    monkeypatch.setattr('os.fork', no_process)
    assert fault_here(str(tmp_path)) == 'this computer has no processes left'
    assert os.listdir(tmp_path) == []


class Shared:
    """What the test and the starter's processes share."""

    def __init__(self, path: Path) -> None:
        self._path = path
        self.arm(0, 0)

    def arm(self, calls: int, number: int) -> None:
        with open(self._path, 'r+b' if self._path.exists() else 'wb') as file:
            file.write(struct.pack(faulty_starter.FORM, calls, number, 0))

    @property
    def count(self) -> int:
        return int(struct.unpack(faulty_starter.FORM, self._path.read_bytes())[2])


@pytest.fixture
def shared(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Shared]:
    """A starter of which calls fail."""
    import edugrade.starter_link

    path = tmp_path / 'shared'
    found = Shared(path)
    script = tmp_path / 'starter.py'
    script.write_text(
        f'import sys\nsys.argv += [{edugrade.starter_link.STARTER!r}, {str(path)!r}]\n'
        f'exec(compile(open({faulty_starter.__file__!r}).read(), "faulty", "exec"))\n'
    )
    monkeypatch.setattr('edugrade.starter_link.STARTER', str(script))
    yield found


def happened(recording: Recording) -> list[object]:
    """What marks are made from."""
    programs = [(program.name, program.returncode, program.exception) for program in recording.processes]
    return [programs, recording.nodes, recording.topics, recording.series('/odom', 'pose.pose.position.x')]


def graded(runner: Runner, submission: Submission) -> Outcome:
    (outcome,) = runner.wait(runner.add(submission, [Scenario('s', {}, 2.0, 7)]))
    return outcome


@pytest.mark.processes
@pytest.mark.parametrize('sandbox', ['auto', 'off'])
def test_each_call_of_a_run_fails_once(shared: Shared, sandbox: str) -> None:
    submission = Submission(str(ROOT / 'solutions' / 'circle.launch.py'))
    with Runner(Limits(sandbox=sandbox), processors=1) as runner:
        graded(runner, submission)
        shared.arm(0, 0)
        right = graded(runner, submission)
        calls = shared.count
        assert right.recording is not None and calls > 50
        for turn in range(1, calls + 1, STEP):
            number = NUMBERS[turn // STEP % len(NUMBERS)]
            shared.arm(turn, number)
            found = graded(runner, submission)
            what = f'call {turn} of {calls} fails with {errno.errorcode[number]}: {found.kind} {found.text}'
            assert found.kind in ('recorded', 'broke'), what
            assert found.recording is None or happened(found.recording) == happened(right.recording), what


@pytest.mark.processes
def test_each_extension_module_that_the_starter_loads_fails_once(shared: Shared) -> None:
    submission = Submission(str(ROOT / 'solutions' / 'circle.launch.py'))
    shared.arm(0, faulty_starter.LOADING)
    with Runner(Limits(), processors=1) as runner:
        right = graded(runner, submission)
    calls = shared.count
    assert right.recording is not None and calls > 20
    for turn in range(1, calls + 1, STEP):
        shared.arm(turn, faulty_starter.LOADING)
        with Runner(Limits(), processors=1) as runner:
            found = graded(runner, submission)
        what = f'module {turn} of {calls}: {found.kind} {found.text}'
        assert found.recording is not None and happened(found.recording) == happened(right.recording), what


@pytest.mark.processes
def test_a_moment_without_processes_neither_removes_the_sandbox_nor_costs_a_mark(shared: Shared) -> None:
    submission = Submission(str(ROOT / 'solutions' / 'circle.launch.py'))
    shared.arm(0, faulty_starter.FIRST_OF_EACH)
    with Runner(Limits(), processors=1) as runner:
        found = graded(runner, submission)
        assert found.recording is not None and not runner.fault()
    assert found.sandbox and found.sandbox['files'] == 'held'


@pytest.mark.processes
def test_without_any_process_there_is_no_mark_and_nothing_was_run(shared: Shared, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr('edugrade.runner.MOST_STARTS', 1)
    submission = Submission(str(ROOT / 'solutions' / 'circle.launch.py'))
    shared.arm(0, faulty_starter.NO_PROCESSES)
    with Runner(Limits(), processors=1) as runner:
        found = graded(runner, submission)
    assert (found.kind, found.text, found.sandbox) == ('broke', 'not graded: this computer has no processes left', None)
    assert found.try_ == REPAIR


def test_no_run_goes_on_without_a_layer_that_fails_for_a_moment() -> None:
    def fails(number: int) -> int:
        raise OSError(number, os.strerror(number))

    assert _tried(lambda: fails(errno.ENOSYS)) == os.strerror(errno.ENOSYS)
    for number in (errno.EAGAIN, errno.ENOMEM, errno.EMFILE):
        with pytest.raises(OSError, match=re.escape(os.strerror(number))):
            _tried(partial(fails, number))


class Faulty:
    """Functions of `os` in this process, of which one call fails."""

    def __init__(self, monkeypatch: pytest.MonkeyPatch) -> None:
        self.count = self.left = self.number = 0
        for module, name in [(os, name) for name in ('open', 'write', 'fork', 'fsync', 'mkdir', 'pipe', 'replace')] + [
            (socket, 'socketpair'),
            *((socket.socket, name) for name in ('sendmsg', 'recvmsg', 'sendall', 'recv')),
            (threading.Thread, 'start'),
            (builtins, 'open'),
        ]:
            monkeypatch.setattr(module, name, self._failing(getattr(module, name)))

    def _failing(self, function: Callable[..., Any]) -> Callable[..., Any]:
        def call(*arguments: Any, **options: Any) -> Any:
            self.count += 1
            self.left -= 1
            if self.left == 0 and function is START:
                raise RuntimeError("can't start new thread")
            if self.left == 0:
                raise OSError(self.number, os.strerror(self.number), 'a file')
            return function(*arguments, **options)

        return call


@pytest.mark.processes
def test_each_call_of_the_grader_fails_once(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    words = [str(ROOT / 'solutions' / 'static_frame.launch.py'), '--advice', '3', '--json', str(tmp_path / 'report.json')]
    assert main(words) == 0
    faulty = Faulty(monkeypatch)
    assert main(words) == 0
    calls = faulty.count
    assert calls > 10
    for turn in range(1, calls + 1, STEP):
        (tmp_path / 'report.json').unlink(missing_ok=True)
        capsys.readouterr()
        faulty.left, faulty.number = turn, NUMBERS[turn // STEP % len(NUMBERS)]
        code = main(words)
        faulty.left = 0
        said = capsys.readouterr()
        what = f'call {turn} of {calls} fails with {errno.errorcode[faulty.number]}: {code} {said.out} {said.err}'
        assert code in (0, 3) or (code == 2 and 'cannot be written' in said.err), what
        assert 'Traceback' not in said.err, what
        assert code == 0 or 'no mark' in said.out or 'not graded' in said.err or 'cannot be written' in said.err, what


@pytest.mark.processes
@pytest.mark.parametrize(
    ('code', 'sentence', 'line'),
    [
        ("for each in range(9999):\n    open(f'f{each}', 'w').close()\n", "[Errno 28] No space left on device: 'f", 2),
        ("open('big', 'wb').write(bytes(80 << 20))\n", '[Errno 27] File too large', 1),
    ],
)
def test_a_run_that_writes_too_much_reads_the_limit_and_its_line(tmp_path: Path, code: str, sentence: str, line: int) -> None:
    file = tmp_path / 'circle.launch.py'
    file.write_text(code + (ROOT / 'solutions' / 'circle.launch.py').read_text())
    with Runner(Limits(), processors=1) as runner:
        found = graded(runner, Submission(str(file)))
    assert (found.kind, found.where) == ('unusable', (str(file), line)) and sentence in found.text
    assert found.try_ == 'write at most 128 MiB, 4096 files, and 64 MiB to one file in a run'


@pytest.mark.processes
def test_a_run_that_fills_its_disk_and_goes_on_is_recorded(tmp_path: Path) -> None:
    file = tmp_path / 'circle.launch.py'
    full = "try:\n    for each in range(9999):\n        open(f'f{each}', 'w').close()\nexcept OSError:\n    pass\n"
    file.write_text(full + (ROOT / 'solutions' / 'circle.launch.py').read_text())
    with Runner(Limits(), processors=1) as runner:
        assert graded(runner, Submission(str(file))).kind == 'recorded'


@pytest.mark.parametrize(
    ('argv', 'module', 'sentence', 'extra'),
    [
        (['/x/bin/ros2', 'bag', 'record'], 'rosbags', 'ros2 bag needs rosbags, which is not installed', 'bags'),
        (['/x/lib/xacro/xacro', 'a.xacro'], 'xacro', 'xacro needs xacro, which is not installed', 'urdf'),
        (
            ['/x/lib/robot_state_publisher/robot_state_publisher'],
            'urdf_parser_py',
            'robot_state_publisher needs urdf-parser-py, which is not installed',
            'urdf',
        ),
    ],
)
def test_a_package_that_this_computer_lacks_gives_no_mark(
    argv: list[str], module: str, sentence: str, extra: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    class Ran:
        processes = [
            SimpleNamespace(argv=['/x/bin/ros2', 'launch'], executable=None),
            SimpleNamespace(argv=argv, executable=None),
        ]

    assert missing_for(Ran) is None  # type: ignore[arg-type]
    monkeypatch.setattr('edugrade.faults.find_spec', lambda name: None if name == module else find_spec(name))
    assert missing_for(Ran) == (sentence, f"run this in the folder of edulaunch's setup.sh: pip install '.[{extra}]'")  # type: ignore[arg-type]
