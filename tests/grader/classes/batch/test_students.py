"""Whose a submission is, by its path.

A class as a table of repositories and folders.
"""

from __future__ import annotations

import os
import subprocess
from pathlib import Path

import pytest
from edugrade.classes.batch.entries import Entry, Finder
from edugrade.classes.batch.students import Student, namer, plain_name

from edulaunch.errors import UnusableInput

PATHS = {
    'anna/circle.launch.py': Student('anna'),
    'anna.tar.gz/a/circle.launch.py': Student('anna'),
    'circle.launch.py': Student('circle'),
    'Ada Lovelace_123_assignsubmission_file_/circle.launch.py': Student('Ada Lovelace', '123'),
    'Ada_von_Lovelace_9_assignsubmission_file/x.launch.py': Student('Ada_von_Lovelace', '9'),
    "O'Neil, José_77_assignsubmission_file_circle.launch.py": Student("O'Neil, José", '77'),
    'lovelaceada_123_456_circle.launch.py': Student('lovelaceada', '123'),
    'lovelaceada_LATE_123_456_work.zip/circle.launch.py': Student('lovelaceada', '123'),
}


@pytest.mark.parametrize('path', PATHS)
def test_the_paths_of_learning_platforms(tmp_path: Path, path: str) -> None:
    assert namer(str(tmp_path))(path) == PATHS[path]


def test_gradescope_keeps_names_beside_the_folders(tmp_path: Path) -> None:
    (tmp_path / 'assignment_1_export').mkdir()
    (tmp_path / 'assignment_1_export' / 'submission_metadata.yml').write_text(
        'submission_11:\n  :submitters:\n  - :name: Ada Lovelace\n    :sid: "007"\n    :email: ada@example.org\n'
        'submission_12:\n  :submitters:\n  - :name: Bob\n    :email: b@example.org\n  - :name: Eve\n'
        'submission_13: {}\n'
    )
    student_of = namer(str(tmp_path))
    assert student_of('assignment_1_export/submission_11/circle.launch.py') == Student('Ada Lovelace', '007')
    assert student_of('submission_12/circle.launch.py') == Student('Bob and Eve', 'b@example.org')
    assert student_of('submission_13/circle.launch.py') == Student('submission_13')


@pytest.mark.parametrize('text', ['{', '- 1', '!!python/object/apply:os.system [id]', 'submission_1: {":submitters": [1]}'])
def test_odd_metadata_names_nobody(tmp_path: Path, text: str) -> None:
    (tmp_path / 'submission_metadata.yml').write_text(text)
    assert namer(str(tmp_path))('submission_1/a') == Student('submission_1')


def test_a_pattern_of_ones_own_goes_first(tmp_path: Path) -> None:
    student_of = namer(str(tmp_path), r'^hw1-(?P<student>[^/]+)')
    assert student_of('hw1-ada/circle.launch.py') == Student('ada')
    assert student_of('bob/circle.launch.py') == Student('bob')


@pytest.mark.parametrize('pattern', ['(', '(.*)'])
def test_a_pattern_without_a_student_is_an_error(tmp_path: Path, pattern: str) -> None:
    with pytest.raises(UnusableInput, match='name pattern'):
        namer(str(tmp_path), pattern)


def test_a_renamed_file_gets_its_own_name_back() -> None:
    assert plain_name('Ada Lovelace_123_assignsubmission_file_circle.launch.py') == 'circle.launch.py'
    assert plain_name('lovelaceada_LATE_123_456_circle.launch-2.py') == 'circle.launch.py'
    assert plain_name('static_frame.launch.py') == 'static_frame.launch.py'


@pytest.mark.parametrize(
    'name', ['circle.launch (1).py', 'circle (12).launch.py', 'circle.launch(2).py', 'lovelaceada_123_456_circle.launch (1).py']
)
def test_the_number_of_a_download_is_no_part_of_the_name(name: str) -> None:
    assert plain_name(name) == 'circle.launch.py'
    assert plain_name('circle (a).launch.py') == 'circle (a).launch.py'


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
    assert all('is not an address of a git repository' in entry.refused for entry in entries[4:-1])
    assert len({entry.path for entry in entries}) == len(entries)


@pytest.mark.parametrize('text', ['', 'name,where\na,b\n', 'student\nAda\n'])
def test_a_table_without_its_columns_is_an_error(tmp_path: Path, text: str) -> None:
    (tmp_path / 'class.csv').write_text(text)
    with pytest.raises(UnusableInput, match='has the columns'):
        find(tmp_path / 'class.csv')
