"""A file of a stranger is read only if it is a regular one, and up to a size; ours are written whole or not at all."""

from __future__ import annotations

import errno
import os
import stat
from pathlib import Path

import pytest
from edugrade.faults import ComputerFault
from edugrade.files import files_below, read_given, read_regular, write_whole

from edulaunch.errors import UnusableInput


def test_the_first_bytes_of_a_regular_file_are_read(tmp_path: Path) -> None:
    (tmp_path / 'a').write_bytes(b'one\r\ntwo')
    assert [read(str(tmp_path / 'a'), most) for read in (read_regular, read_given) for most in (4, 99)] == [
        b'one\r',
        b'one\r\ntwo',
    ] * 2


@pytest.mark.parametrize('kind', ['pipe', 'device', 'folder'])
def test_what_is_no_regular_file_is_not_read(tmp_path: Path, kind: str) -> None:
    os.mkfifo(tmp_path / 'pipe')
    path = {'pipe': str(tmp_path / 'pipe'), 'device': '/dev/zero', 'folder': str(tmp_path)}[kind]
    with pytest.raises(OSError) as caught:
        read_regular(path, 9)
    assert kind == 'folder' or (caught.value.errno, caught.value.filename) == (errno.EINVAL, path)
    with pytest.raises(UnusableInput, match=f'^the key {path} cannot be read: (it is not a regular file|Is a directory)') as told:
        read_given(path, 9, 'the key ', help='name another one')
    assert 'name another one' in str(told.value)


@pytest.mark.parametrize(('path', 'why'), [('no/such', 'No such file or directory'), ('a\0b', 'embedded null byte')])
def test_what_cannot_be_read_says_why(path: str, why: str) -> None:
    with pytest.raises(UnusableInput) as caught:
        read_given(path, 9)
    assert str(caught.value) == f'{path} cannot be read: {why}'


def test_a_fault_of_the_computer_is_not_blamed_on_the_file(monkeypatch: pytest.MonkeyPatch) -> None:
    def full(*_: object) -> int:
        raise OSError(errno.EMFILE, os.strerror(errno.EMFILE))

    monkeypatch.setattr(os, 'open', full)
    with pytest.raises(ComputerFault):
        read_given('a', 9)


def test_files_are_found_in_order_and_folders_can_be_left_out(tmp_path: Path) -> None:
    for name in ('b/z', 'b/left/x', 'a', 'c', 'left'):
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text('') if not (tmp_path / name).is_dir() else None
    asked: list[tuple[str, str]] = []

    def is_taken(name: str, inside: str) -> bool:
        asked.append((name, inside))
        return (name, inside) != ('left', 'b/')

    assert list(files_below(str(tmp_path), is_taken)) == ['a', 'c', 'left', 'b/z']
    assert asked[-2:] == [('left', 'b/'), ('z', 'b/')]


def test_the_file_has_the_text_and_nothing_is_left_beside_it(tmp_path: Path) -> None:
    write_whole(str(tmp_path / 'a'), 'é\n')
    assert (tmp_path / 'a').read_bytes() == 'é\n'.encode()
    assert [path.name for path in tmp_path.iterdir()] == ['a']


def test_a_place_that_cannot_be_written_is_named(tmp_path: Path) -> None:
    with pytest.raises(UnusableInput, match='cannot be written: No such file or directory'):
        write_whole(str(tmp_path / 'nowhere' / 'a'), 'x')


def test_a_device_and_a_pipe_are_written_to_and_stay_what_they_are(tmp_path: Path) -> None:
    write_whole('/dev/null', 'x')
    assert stat.S_ISCHR(os.stat('/dev/null').st_mode)
    os.mkfifo(tmp_path / 'pipe')
    reader = os.open(tmp_path / 'pipe', os.O_RDONLY | os.O_NONBLOCK)
    write_whole(str(tmp_path / 'pipe'), 'words')
    assert (os.read(reader, 99), stat.S_ISFIFO(os.stat(tmp_path / 'pipe').st_mode)) == (b'words', True)
    os.close(reader)


def test_a_full_device_is_an_error_and_stays(tmp_path: Path) -> None:
    link = tmp_path / 'full'
    link.symlink_to('/dev/full')
    for path in ('/dev/full', str(link)):
        with pytest.raises(UnusableInput, match='No space left'):
            write_whole(path, 'x')
    assert stat.S_ISCHR(os.stat('/dev/full').st_mode)
    assert link.is_symlink()


def test_what_a_link_points_to_is_replaced_and_not_the_link(tmp_path: Path) -> None:
    (tmp_path / 'link').symlink_to('target')
    write_whole(str(tmp_path / 'link'), 'x')
    assert ((tmp_path / 'link').is_symlink(), (tmp_path / 'target').read_text()) == (True, 'x')


def test_half_a_character_is_written_as_its_number(tmp_path: Path) -> None:
    write_whole(str(tmp_path / 'a'), 'a\udcffb')
    assert (tmp_path / 'a').read_text() == 'a\\udcffb'


def test_a_path_that_no_system_has_is_an_error() -> None:
    with pytest.raises(UnusableInput, match='cannot be written'):
        write_whole('a\0b', 'x')
