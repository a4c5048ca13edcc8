"""Every student of a class has an entry: with work to be graded, or with the reason why not."""

from __future__ import annotations

import os
import shutil
import zipfile
from pathlib import Path

import pytest
from edugrade.classes.batch.entries import NOTHING, Entry, Finder

from edulaunch.errors import UnusableInput


def find(folder: Path, pattern: str | None = None) -> list[Entry]:
    finder = Finder(str(folder), f'{folder}.unpacked', lambda name: name in ('circle', 'robot'), pattern)
    return finder.entries()


def seen(entries: list[Entry]) -> list[tuple[str, str, str]]:
    return [(entry.student, entry.path, entry.refused) for entry in entries]


def packed(path: Path, *names: str) -> Path:
    path.parent.mkdir(parents=True, exist_ok=True)
    with zipfile.ZipFile(path, 'w') as archive:
        for name in names:
            archive.writestr(name, f'# {name}')
    return path


def test_folders_archives_and_files(tmp_path: Path) -> None:
    folder = tmp_path / 'class'
    for name in (
        'anna/circle.launch.py',
        'bert/ws/src/robot/package.xml',
        'bert/notes.txt',
        'carl.launch.py',
        'dora/other.launch.py',
    ):
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text('<package><name>robot</name></package>')
    packed(folder / 'eve.zip', 'hw/circle.launch.py', '__MACOSX/hw/._circle.launch.py', 'hw/deep/circle_launch.xml')
    packed(folder / 'fred' / 'work.zip', '../circle.launch.py')
    (folder / 'gina.rar').write_text('')
    (folder / 'hugo').symlink_to(folder / 'anna')
    (folder / 'ida').mkdir()
    (folder / 'ida' / 'circle.launch.py').symlink_to(folder / 'anna' / 'circle.launch.py')
    (folder / '.git').mkdir()
    entries = find(folder)
    assert seen(entries) == [
        ('anna', 'anna/circle.launch.py', ''),
        ('bert', 'bert/ws/src/robot', ''),
        ('dora', 'dora', f'{NOTHING}; it contains other.launch.py'),
        ('eve', 'eve.zip/hw/circle.launch.py', ''),
        ('eve', 'eve.zip/hw/deep/circle_launch.xml', ''),
        ('fred', 'fred/work.zip', "the archive contains a path that leads out of it: '../circle.launch.py'"),
        ('gina.rar', 'gina.rar', 'edugrade cannot read this kind of archive'),
        ('hugo', 'hugo', 'it is a link, and links are not followed'),
        ('ida', 'ida/circle.launch.py', 'it is a link, and links are not followed'),
    ]
    assert Path(entries[3].file).read_text() == '# hw/circle.launch.py'


def test_a_download_of_a_platform_may_stay_packed(tmp_path: Path) -> None:
    inner = packed(tmp_path / 'inner.zip', 'circle.launch.py')
    with zipfile.ZipFile(tmp_path / 'all.zip', 'w') as archive:
        archive.writestr('Ada L_1_assignsubmission_file_/circle.launch.py', 'x')
        archive.writestr('Bob_2_assignsubmission_file_circle.launch.py', 'y')
        archive.write(inner, 'Cleo_3_assignsubmission_file_/work.zip')
    entries = find(tmp_path / 'all.zip')
    assert [(entry.student, entry.id) for entry in entries] == [('Ada L', '1'), ('Bob', '2'), ('Cleo', '3')]
    assert [os.path.basename(entry.file) for entry in entries] == ['circle.launch.py'] * 3


def test_archives_in_archives_end(tmp_path: Path) -> None:
    path = packed(tmp_path / '0.zip', 'circle.launch.py')
    for number in (1, 2, 3):
        with zipfile.ZipFile(tmp_path / f'{number}.zip', 'w') as archive:
            archive.write(path, 'inner.zip')
        path = tmp_path / f'{number}.zip'
    (tmp_path / 'class').mkdir()
    path.rename(tmp_path / 'class' / 'anna.zip')
    ((student, _, refused),) = seen(find(tmp_path / 'class'))
    assert (student, refused) == ('anna', 'archives contain archives, more than 2 deep')


def test_what_was_unpacked_before_is_gone(tmp_path: Path) -> None:
    packed(tmp_path / 'class' / 'anna.zip', 'circle.launch.py')
    (tmp_path / 'class.unpacked' / '1').mkdir(parents=True)
    (tmp_path / 'class.unpacked' / '1' / 'circle.launch.py').write_text('old')
    (entry,) = find(tmp_path / 'class')
    assert Path(entry.file).read_text() == '# circle.launch.py'


def test_what_cannot_be_read_or_is_deep_costs_nobody_else(tmp_path: Path) -> None:
    (tmp_path / 'class' / 'anna').mkdir(parents=True)
    (tmp_path / 'class' / 'anna' / 'circle.launch.py').write_text('x')
    (tmp_path / 'class' / 'bert' / ('d/' * 60)).mkdir(parents=True)
    (tmp_path / 'class' / 'carl').mkdir()
    (tmp_path / 'class' / 'carl' / 'loop').symlink_to('.')
    os.mkfifo(tmp_path / 'class' / 'pipe.zip')
    assert [refused for _, _, refused in seen(find(tmp_path / 'class'))] == [
        '',
        NOTHING,
        NOTHING,
        'the archive is not a regular file',
    ]


def test_a_folder_that_is_none_is_an_error(tmp_path: Path) -> None:
    with pytest.raises(UnusableInput, match='nowhere does not exist'):
        find(tmp_path / 'nowhere')


def test_what_a_student_handed_in_ends_at_the_own_folder(tmp_path: Path) -> None:
    """A run may read all of it, and nothing of others: also of those who are packed together."""
    for student in ('anna', 'ben'):
        package = tmp_path / 'class' / student / 'src' / 'robot'
        (package / 'launch').mkdir(parents=True)
        (package / 'package.xml').write_text('<package><name>robot</name></package>')
        (package / 'launch' / 'robot.launch.py').write_text('')
    shutil.make_archive(str(tmp_path / 'all'), 'zip', tmp_path / 'class')
    shutil.make_archive(str(tmp_path / 'class' / 'carl' / 'mine'), 'zip', tmp_path / 'class' / 'anna')
    unpacked = tmp_path / 'unpacked'
    found = Finder(str(tmp_path / 'class'), str(unpacked), lambda name: name == 'robot').entries()
    assert {entry.student: entry.root for entry in found} == {
        'anna': str(tmp_path / 'class' / 'anna'),
        'ben': str(tmp_path / 'class' / 'ben'),
        'carl': str(unpacked / '1'),
    }
    found = Finder(str(tmp_path / 'all.zip'), str(unpacked), lambda name: name == 'robot').entries()
    assert {entry.student: entry.root for entry in found} == {name: str(unpacked / 'all' / name) for name in ('anna', 'ben')}
