"""Rubrics are found by name or file."""

from __future__ import annotations

from pathlib import Path

import pytest
from edugrade.rubrics.catalogue import exercises, find_rubric

from edulaunch.errors import UnusableInput

RUBRIC = "from edugrade import Rubric\nRUBRIC = Rubric(title='Mine', scenarios=lambda random: [], checks=[])\n"


def test_the_name_of_a_submission_finds_its_rubric() -> None:
    assert find_rubric('circle')[0] == 'circle'


def test_a_given_name_goes_before_that_of_the_submission() -> None:
    assert find_rubric('my_try', 'circle')[0] == 'circle'


def test_a_file_is_a_rubric_when_it_defines_one(tmp_path: Path) -> None:
    (tmp_path / 'mine.py').write_text(RUBRIC)
    name, rubric = find_rubric('circle', str(tmp_path / 'mine.py'))
    assert (name, rubric.title) == ('mine', 'Mine')


def test_without_a_near_name_all_are_listed() -> None:
    with pytest.raises(UnusableInput) as error:
        find_rubric('zzzzzz')
    assert error.value.help is not None
    assert error.value.help.startswith('name one of these rubrics')
    assert all(name in error.value.message for name in exercises())
