"""Notes for teachers: shown to who asks for them, and never handed out."""

from __future__ import annotations

from pathlib import Path
from zipfile import ZipFile

import pytest

from edulaunch.course.lesson_form import lesson_problems
from edulaunch.course.lessons import time_plan
from edulaunch.desk.cli.main import main

NOTES = '# Notes\n\n| minutes | section | what |\n|---:|---|---|\n| 5 | 1.1 Drive | drive |\n| 10 | 1.2 The exercise | do |\n'


@pytest.fixture
def mine(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> Path:
    main(['course', 'new', str(tmp_path / 'mine')])
    notes = tmp_path / 'mine' / 'lessons' / 'notes'
    notes.mkdir()
    (notes / '01_circle.md').write_text(NOTES)
    capsys.readouterr()
    return tmp_path / 'mine'


def test_notes_are_listed_and_shown(mine: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(['course', 'notes', '--course', str(mine)]) == 0
    assert capsys.readouterr().out == '01_circle   15 minutes\n'
    for name in ('1', '01_circle', '01_circle.ipynb'):
        assert main(['course', 'notes', name, '--course', str(mine)]) == 0
        assert capsys.readouterr().out.strip() == NOTES.strip()
    assert main(['course', 'notes', '7', '--course', str(mine)]) == 2
    assert 'choose one of: 01_circle' in capsys.readouterr().err
    assert time_plan(NOTES) == [(5, '1.1 Drive'), (10, '1.2 The exercise')]


def test_students_do_not_get_them(mine: Path) -> None:
    assert main(['course', 'release', str(mine), str(mine.parent / 'out.zip'), '--with-rubrics']) == 0
    assert main(['course', 'copy', str(mine.parent / 'copy'), '--course', str(mine)]) == 0
    assert not [name for name in ZipFile(mine.parent / 'out.zip').namelist() if 'notes' in name]
    assert not list((mine.parent / 'copy').rglob('*notes*'))
    assert main(['course', 'copy', str(mine.parent / 'ours')]) == 0
    assert not list((mine.parent / 'ours').rglob('notes'))


def test_notes_without_a_lesson_are_a_problem(mine: Path) -> None:
    assert list(lesson_problems(str(mine))) == []
    (mine / 'lessons' / 'notes' / '02_gone.md').write_text('# Gone\n')
    assert list(lesson_problems(str(mine))) == ['lessons/notes/02_gone.md: there is no lesson of this name']


def test_a_course_without_notes_says_how_to_write_some(mine: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (mine / 'lessons' / 'notes' / '01_circle.md').unlink()
    assert main(['course', 'notes', '--course', str(mine)]) == 2
    assert 'lessons/notes/01_name.md' in capsys.readouterr().err
