"""Hints are found for a file wherever it lies."""

from __future__ import annotations

from pathlib import Path

import pytest
from edugrade.attempts import find_hint
from edugrade.submission import Submission

from edulaunch.errors import UnusableInput

REPOSITORY = Path(__file__).resolve().parents[2]
MANIFEST = """[[exercise]]
file = 'own.launch.py'
title = 'My own'
lesson = 'x'
points = 1
hints = ['one', 'two', 'three']
"""


def test_a_hint_names_the_exercise_and_its_level() -> None:
    text = find_hint(Submission(str(REPOSITORY / 'exercises' / 'large_project')), 2)
    assert text.startswith('A large project, hint 2 of 3: Import GroupAction from launch.actions')


def test_a_manifest_above_the_file_goes_first(tmp_path: Path) -> None:
    (tmp_path / 'course.toml').write_text(MANIFEST)
    (tmp_path / 'deep' / 'er').mkdir(parents=True)
    file = tmp_path / 'deep' / 'er' / 'own.launch.py'
    file.touch()
    assert find_hint(Submission(str(file)), 3) == 'My own, hint 3 of 3: three'


def test_a_file_far_from_the_course_gets_the_hints_that_came_with_edugrade(tmp_path: Path) -> None:
    (tmp_path / 'circle.launch.py').touch()
    assert find_hint(Submission(str(tmp_path / 'circle.launch.py')), 1).startswith('A circle of any radius, hint 1')


def test_an_unknown_exercise_names_those_there_are(tmp_path: Path) -> None:
    (tmp_path / 'other.launch.py').touch()
    with pytest.raises(UnusableInput) as error:
        find_hint(Submission(str(tmp_path / 'other.launch.py')), 1)
    assert error.value.help is not None
    assert 'large_project' in error.value.help


def test_an_unknown_level_is_refused() -> None:
    with pytest.raises(UnusableInput, match='there is no hint of level 4'):
        find_hint(Submission(str(REPOSITORY / 'exercises' / 'circle.launch.py')), 4)
