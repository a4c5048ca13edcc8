"""A file is written whole or not at all."""

from __future__ import annotations

import os
import stat
from pathlib import Path

import pytest
from edugrade.files import write_whole

from edulaunch.errors import UnusableInput


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
