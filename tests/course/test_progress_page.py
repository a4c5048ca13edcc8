"""How far one has come."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from edugrade.progress_file import ProgressFile

from edulaunch.course import predict, progress, quiz
from tests.course.test_quizzes import ONE

COURSE = """\
[[exercise]]
file = 'circle.launch.py'
title = 'A circle'
lesson = '01_first_launch'
points = 12
hints = ['a', 'b', 'c']
"""
TABLE = """\
lesson                     predictions  questions  exercises  points
1. Your first launch file  1 of 2       0 of 1     0 of 1     7 of 12
broken

To repeat: quiz('two-names'); check('circle')."""


@pytest.fixture(autouse=True)
def _in_a_course(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    lessons = tmp_path / 'lessons'
    lessons.mkdir()
    (lessons / 'questions.toml').write_text(ONE)
    (tmp_path / 'exercises').mkdir()
    (tmp_path / 'exercises' / 'course.toml').write_text(COURSE)
    cells = ['# 1. Your first launch file\n\nText', "predict('one', ...)", "x = 1\npredict('two', ...)"]
    (lessons / '01_first_launch.ipynb').write_text(
        json.dumps({'cells': [{'cell_type': 'markdown', 'source': [cell]} for cell in cells]})
    )
    (lessons / '02.ipynb').write_text('{')
    monkeypatch.chdir(lessons)


def test_lessons_with_what_was_done_and_what_to_repeat() -> None:
    predict('one', 1)
    quiz('two-names', 'a')
    with ProgressFile.changing('.') as file:
        file.of('circle').attempt(7, 12, False)
        file.save()
    assert repr(progress()) == TABLE.replace('broken', '02')
    html = progress()._repr_html_()
    assert '<th scope="row">1. Your first launch file</th><td>1 of 2</td>' in html


def test_at_the_beginning_there_is_nothing_to_repeat() -> None:
    assert repr(progress()).endswith('0 of 1     0 of 1     0 of 12\n02\n\nNothing to repeat.')


def test_an_answer_that_was_mended_counts() -> None:
    quiz('two-names', 'a')
    quiz('two-names', 'b')
    assert '1 of 1' in repr(progress()) and repr(progress()).endswith('Nothing to repeat.')


def test_without_lessons_it_says_where_to_ask(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / 'empty').mkdir()
    monkeypatch.chdir(tmp_path / 'empty')
    assert 'There are no lessons here' in repr(progress())


def test_no_more_than_five_things_are_to_repeat() -> None:
    with ProgressFile.changing('.') as file:
        for number in range(7):
            file.of(f'task{number}').attempt(7, 12, False)
        file.save()
    assert repr(progress()).count("check('task") == 5
