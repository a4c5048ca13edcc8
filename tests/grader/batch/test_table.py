"""A class as a table of repositories and folders."""

from __future__ import annotations

import os
import subprocess
from pathlib import Path

import pytest
from edugrade.batch.entries import Entry, Finder

from edulaunch.errors import UnusableInput


def repository(path: Path) -> str:
    """A git repository with a launch file, a link and a hook; gives its commit."""
    path.mkdir()
    (path / 'circle.launch.py').write_text('x')
    (path / 'link').symlink_to('/etc/passwd')
    who = ['-c', 'user.name=a', '-c', 'user.email=a@example.org']
    for words in (['init', '-q', '-b', 'main'], ['add', '-A'], [*who, 'commit', '-q', '-m', 'a']):
        subprocess.run(['git', '-C', str(path), *words], check=True, capture_output=True)
    return subprocess.run(
        ['git', '-C', str(path), 'rev-parse', 'HEAD'], check=True, capture_output=True, text=True
    ).stdout.strip()


def find(table: Path) -> list[Entry]:
    return Finder(str(table), f'{table}.unpacked', lambda name: name == 'circle', None).entries()


def test_repositories_are_cloned_and_folders_are_taken(tmp_path: Path) -> None:
    commit = repository(tmp_path / 'repo')
    (tmp_path / 'work').mkdir()
    (tmp_path / 'work' / 'circle.launch.py').write_text('y')
    (tmp_path / 'class.csv').write_text(
        f'Student,ID,url,path,ref\nAda,7,file://{tmp_path}/repo,,main\nBob,8,,work,\nCleo,9,repo,,\nAda,10,,nowhere,\n'
        'Eve,11,ext::sh -c id,,\nFay,12,--upload-pack=id,,\nGus,13,repo,,--x\nHal,14,file:///nowhere,,\n'
    )
    entries = find(tmp_path / 'class.csv')
    assert [(entry.student, entry.id, bool(entry.refused)) for entry in entries[:4]] == [
        ('Ada', '7', False),
        ('Bob', '8', False),
        ('Cleo', '9', False),
        ('Ada', '10', True),
    ]
    assert entries[0].origin == f'file://{tmp_path}/repo {commit}'
    assert not os.path.islink(os.path.join(os.path.dirname(entries[0].file), 'link'))
    assert [entry.refused.partition(':')[0] for entry in entries[4:]][-1] == 'the repository could not be cloned'
    assert all('is no address of a git repository' in entry.refused for entry in entries[4:-1])
    assert len({entry.path for entry in entries}) == len(entries)


@pytest.mark.parametrize('text', ['', 'name,where\na,b\n', 'student\nAda\n'])
def test_a_table_without_its_columns_is_an_error(tmp_path: Path, text: str) -> None:
    (tmp_path / 'class.csv').write_text(text)
    with pytest.raises(UnusableInput, match='has the columns'):
        find(tmp_path / 'class.csv')
