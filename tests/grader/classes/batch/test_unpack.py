"""What comes out of an archive is files and folders below its own folder, and no more of them than may be."""

from __future__ import annotations

import bz2
import gzip
import io
import os
import stat
import tarfile
import zipfile
from collections.abc import Callable
from pathlib import Path

import pytest
from edugrade.classes.batch.unpack import Bounds, unpack

from edulaunch.errors import UnusableInput

SMALL = Bounds(files=20, unpacked=3 << 20, packed=1 << 20)


def zip_of(path: Path, *members: tuple[str | zipfile.ZipInfo, bytes]) -> Path:
    with zipfile.ZipFile(path, 'w', zipfile.ZIP_DEFLATED) as archive:
        for name, data in members:
            archive.writestr(name, data)
    return path


def zip_member(name: str, mode: int) -> zipfile.ZipInfo:
    info = zipfile.ZipInfo(name)
    info.external_attr = mode << 16
    return info


def tar_of(path: Path, *members: tarfile.TarInfo, data: bytes = b'x', mode: str = 'w:gz') -> Path:
    with tarfile.open(path, mode) as archive:  # type: ignore[call-overload]
        for member in members:
            if member.isreg():
                member.size = len(data)
            archive.addfile(member, io.BytesIO(data) if member.isreg() else None)
    return path


def tar_member(name: str, kind: bytes = tarfile.REGTYPE, link: str = '') -> tarfile.TarInfo:
    info = tarfile.TarInfo(name)
    info.type, info.linkname = kind, link
    return info


def names(folder: Path) -> list[str]:
    return sorted(str(path.relative_to(folder)) for path in folder.rglob('*') if path.is_file())


@pytest.mark.parametrize('make', ['zip', 'w', 'w:gz', 'w:bz2'])
def test_files_and_folders_come_out(tmp_path: Path, make: str) -> None:
    if make == 'zip':
        archive = zip_of(tmp_path / 'a.zip', ('pkg/', b''), ('pkg/launch/a.launch.py', b'x'), ('./b.launch.py', b'x'))
    else:
        files = [tar_member('pkg', tarfile.DIRTYPE), tar_member('pkg/launch/a.launch.py'), tar_member('./b.launch.py')]
        archive = tar_of(tmp_path / 'a.tar.gz', *files, mode=make)
    unpack(str(archive), str(tmp_path / 'out'), SMALL)
    assert names(tmp_path / 'out') == ['b.launch.py', 'pkg/launch/a.launch.py']
    assert (tmp_path / 'out' / 'b.launch.py').read_bytes() == b'x'


def encrypted(path: Path) -> Path:
    zip_of(path, ('a', b'x'))
    data = bytearray(path.read_bytes())
    for mark, place in ((b'PK\x03\x04', 6), (b'PK\x01\x02', 8)):
        data[data.index(mark) + place] |= 1
    path.write_bytes(data)
    return path


def huge_header(path: Path) -> Path:
    """A tar whose extended header alone says that it is a gigabyte."""
    info = tar_member('x', tarfile.XHDTYPE)
    info.size = 1 << 30
    with gzip.open(path, 'wb') as file:
        file.write(info.tobuf(tarfile.GNU_FORMAT))
        for _ in range(8):
            file.write(bytes(1 << 20))
    return path


ODD: dict[str, tuple[Callable[[Path], Path], str]] = {
    'a path upwards': (lambda path: zip_of(path, ('a/../../b', b'')), 'leads out of it'),
    'an absolute path': (lambda path: zip_of(path, ('/etc/x', b'')), 'leads out of it'),
    'a backslash': (lambda path: zip_of(path, ('a\\..\\b', b'')), 'odd'),
    'a drive': (lambda path: zip_of(path, ('C:/b', b'')), 'odd'),
    'a control character': (lambda path: zip_of(path, ('a\x1b[2J', b'')), 'odd'),
    'a long name': (lambda path: zip_of(path, ('a' * 300, b'')), 'too long'),
    'a deep path': (lambda path: zip_of(path, ('a/' * 40 + 'b', b'')), 'deeper than 30'),
    'a link in a zip': (lambda path: zip_of(path, (zip_member('a', stat.S_IFLNK | 0o777), b'/etc/passwd')), 'a link'),
    'a device in a zip': (lambda path: zip_of(path, (zip_member('a', stat.S_IFCHR | 0o600), b'')), 'what is no file'),
    'two of one name': (lambda path: tar_of(path, tar_member('a'), tar_member('a')), 'two files with one name'),
    'a file as a folder': (lambda path: zip_of(path, ('a', b''), ('a/b', b'')), 'cannot be unpacked'),
    'a link in a tar': (lambda path: tar_of(path, tar_member('a', tarfile.SYMTYPE, '/etc')), 'a link'),
    'a hard link': (lambda path: tar_of(path, tar_member('a', tarfile.LNKTYPE, '/etc/passwd')), 'a link'),
    'a device': (lambda path: tar_of(path, tar_member('a', tarfile.CHRTYPE)), 'what is no file'),
    'a pipe': (lambda path: tar_of(path, tar_member('a', tarfile.FIFOTYPE)), 'what is no file'),
    'many files': (lambda path: zip_of(path, *((f'{n}', b'') for n in range(25))), 'more than 20 files'),
    'very many files': (lambda path: zip_of(path, *((f'{n}' * 90, b'') for n in range(60))), 'more than 20 files'),
    'many bytes': (lambda path: zip_of(path, ('a', os.urandom(1 << 19) * 2), ('b', os.urandom(1 << 18) * 12)), 'MiB'),
    'a ratio': (lambda path: zip_of(path, ('a', bytes(2 << 20))), 'more than 200 times'),
    'a tar of zeros': (lambda path: tar_of(path, tar_member('a'), data=bytes(2 << 20)), 'more than 200 times'),
    'a huge header': (huge_header, 'MiB'),
    'a password': (encrypted, 'encrypted'),
    'no archive': (lambda path: path.write_bytes(b'hello') and path or path, 'cannot be unpacked'),
    'half a zip': (
        lambda path: path.write_bytes(zip_of(path, ('a', b'x' * 99)).read_bytes()[20:]) and path or path,
        'cannot be unpacked',
    ),
    'half a gzip': (lambda path: path.write_bytes(gzip.compress(os.urandom(4000))[:900]) and path or path, 'cannot be unpacked'),
    'half a bzip2': (lambda path: path.write_bytes(bz2.compress(os.urandom(4000))[:900]) and path or path, 'cannot be unpacked'),
    'xz': (lambda path: tar_of(path, tar_member('a'), mode='w:xz'), 'xz'),
}


@pytest.mark.parametrize('name', ODD)
def test_what_is_odd_is_refused_and_named(tmp_path: Path, name: str) -> None:
    make, words = ODD[name]
    archive = make(tmp_path / 'archive.zip')
    with pytest.raises(UnusableInput, match=words) as caught:
        unpack(str(archive), str(tmp_path / 'out' / 'a'), SMALL)
    assert str(caught.value).isprintable() or '\n' in str(caught.value)
    assert sorted(path.name for path in tmp_path.iterdir()) in (['archive.zip', 'out'], ['archive.zip'])


def test_a_pipe_and_a_large_file_are_no_archives(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / 'a.zip')
    with pytest.raises(UnusableInput, match='regular'):
        unpack(str(tmp_path / 'a.zip'), str(tmp_path / 'out'), SMALL)
    (tmp_path / 'b.zip').write_bytes(bytes((1 << 20) + 1))
    with pytest.raises(UnusableInput, match='larger than 1 MiB'):
        unpack(str(tmp_path / 'b.zip'), str(tmp_path / 'out'), SMALL)
