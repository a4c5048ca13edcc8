"""Whose a submission is, by its path."""

from __future__ import annotations

from pathlib import Path

import pytest
from edugrade.batch.names import Student, namer, plain_name

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
