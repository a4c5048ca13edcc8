"""A save that fails loses nothing: each call of the system fails once, each in turn."""

from __future__ import annotations

import builtins
import errno
import fcntl
import io
import os
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from edulaunch.desk.cli.main import main
from edulaunch.engine.recording import Recording
from edulaunch.engine.recording.safe_file import remove_drafts, write_safely
from edulaunch.errors import RecordingError

FAULTS = (errno.ENOSPC, errno.EIO, errno.EROFS, errno.EMFILE, errno.ENOMEM)
HARMLESS = {'folder open', 'folder fsync'}
"""Steps after the new recording is safe."""


class FailingFile(io.FileIO):
    """A file whose writes are steps."""

    faults: Faults

    def write(self, data: Any) -> int:
        self.faults.step('write')
        return super().write(data)


class Faults:
    """Stands in for the system's calls of a save, and lets one of them fail."""

    def __init__(self, monkeypatch: pytest.MonkeyPatch, fails: int, code: int) -> None:
        self.steps: list[str] = []
        self.fails, self.code = fails, code
        self.open, self.fsync = os.open, os.fsync
        self.opened: set[int] = set()
        replace = os.replace
        monkeypatch.setattr('edulaunch.engine.recording.safe_file.open', self.open_file, raising=False)
        monkeypatch.setattr(os, 'open', self.open_folder)
        monkeypatch.setattr(os, 'fsync', self.sync)
        monkeypatch.setattr(os, 'replace', lambda *names: (self.step('rename'), replace(*names)))

    def step(self, what: str) -> None:
        self.steps.append(what)
        if len(self.steps) == self.fails:
            raise OSError(self.code, os.strerror(self.code))

    def open_file(self, path: str, mode: str) -> Any:
        if 'x' not in mode:
            return builtins.open(path, mode)
        self.step('open')
        file = FailingFile(path, mode)
        file.faults = self
        return io.BufferedWriter(file, 512)

    def open_folder(self, path: Any, flags: int, *rest: Any, **named: Any) -> int:
        if os.path.isdir(path):
            self.step('folder open')
        number = self.open(path, flags, *rest, **named)
        self.opened.add(number)
        return number

    def sync(self, number: int) -> None:
        self.step('folder fsync' if number in self.opened else 'fsync')
        self.fsync(number)


@pytest.fixture
def older(tmp_path: Path, recording: Recording) -> Path:
    (tmp_path / 'run.rec').write_bytes(recording.to_bytes().replace(b'"seed":7', b'"seed":6'))
    return tmp_path / 'run.rec'


@pytest.mark.parametrize('code', FAULTS, ids=errno.errorcode.get)
def test_each_step_of_a_save_fails_once(older: Path, recording: Recording, monkeypatch: pytest.MonkeyPatch, code: int) -> None:
    before = older.read_bytes()
    with monkeypatch.context() as patch:
        steps = Faults(patch, 0, code).steps
        recording.save(older)
    assert [*dict.fromkeys(steps)] == ['open', 'write', 'fsync', 'rename', 'folder open', 'folder fsync'], steps
    for number, step in enumerate(steps, 1):
        older.write_bytes(before)
        with monkeypatch.context() as patch:
            Faults(patch, number, code)
            if step in HARMLESS:
                recording.save(older)
            else:
                with pytest.raises(RecordingError, match=f'cannot write the recording .*: {os.strerror(code)}'):
                    recording.save(older)
        assert older.read_bytes() == (recording.to_bytes() if step in HARMLESS else before), step
        assert os.listdir(older.parent) == ['run.rec'], step


def test_the_disk_has_the_recording_before_its_name(older: Path, recording: Recording, monkeypatch: pytest.MonkeyPatch) -> None:
    steps = Faults(monkeypatch, 0, 0).steps
    recording.save(older)
    assert steps[steps.index('fsync') :] == ['fsync', 'rename', 'folder open', 'folder fsync']


def test_a_command_whose_recording_cannot_be_written(
    older: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    before = older.read_bytes()
    (older.parent / 'one.launch.py').write_text(
        'from launch import LaunchDescription\ndef generate_launch_description():\n    return LaunchDescription([])\n'
    )
    Faults(monkeypatch, 1, errno.ENOSPC)
    assert main(['launch', str(older.parent / 'one.launch.py'), '--fast', '--record', str(older)]) == 2
    assert capsys.readouterr().err == f"error: cannot write the recording '{older}': No space left on device\n"
    assert older.read_bytes() == before


def test_two_writers_of_one_file_do_not_meet(tmp_path: Path) -> None:
    target = tmp_path / 'run.rec'

    def lines() -> Iterator[bytes]:
        yield b'one\n'
        write_safely(target, [b'other\n'])
        assert target.read_bytes() == b'other\n'
        yield b'two\n'

    write_safely(target, lines())
    assert target.read_bytes() == b'one\ntwo\n' and os.listdir(tmp_path) == ['run.rec']


def test_drafts_of_killed_programs_are_removed_and_those_of_living_ones_stay(tmp_path: Path) -> None:
    names = ['.run.rec.17-ab.part', '.run.rec.18-cd.part', '.other.rec.17-ab.part', 'run.rec.part']
    for name in names:
        (tmp_path / name).write_bytes(b'a draft')
    with open(tmp_path / names[1], 'rb') as alive:
        fcntl.flock(alive, fcntl.LOCK_EX)
        remove_drafts(tmp_path / 'run.rec')
    assert sorted(os.listdir(tmp_path)) == sorted(names[1:])


def test_an_error_and_an_interrupt_leave_no_draft(older: Path) -> None:
    before = older.read_bytes()

    def lines(error: BaseException) -> Iterator[bytes]:
        yield b'one\n'
        raise error

    for error in (MemoryError(), KeyboardInterrupt()):
        with pytest.raises(type(error)):
            write_safely(older, lines(error))
        assert older.read_bytes() == before and os.listdir(older.parent) == ['run.rec']


def test_a_name_as_long_as_names_can_be(tmp_path: Path) -> None:
    write_safely(tmp_path / ('ä' * 127), [b'one\n'])
    assert (tmp_path / ('ä' * 127)).read_bytes() == b'one\n'


def test_no_memory_for_a_save_is_a_sentence(older: Path, recording: Recording, monkeypatch: pytest.MonkeyPatch) -> None:
    def no_memory(*_: Any, **__: Any) -> Any:
        raise MemoryError

    before = older.read_bytes()
    monkeypatch.setattr('edulaunch.engine.recording.file_format.json.dumps', no_memory)
    with pytest.raises(RecordingError, match='this computer has no memory left'):
        recording.save(older)
    assert older.read_bytes() == before
