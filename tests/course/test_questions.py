"""The file of questions, as authors write it and as students get it."""

from __future__ import annotations

from pathlib import Path

import pytest

from edulaunch.course.questions import FILE, SEALED, find_questions, questions_file, read_questions, seal
from edulaunch.errors import UnusableInput
from tests.house import ROOT

ONE = """\
[[question]]
name = 'two-names'
lesson = '01_first_launch'
text = 'Two nodes of one name: what happens?'
right = 'b'
choices = [
    ['The second one is refused.', 'ROS 2 starts both.'],
    ['Both run, and tools mix them up.', 'A warning is all you get.'],
]

[[explanation]]
name = 'why-a-warning'
lesson = '01_first_launch'
answer = 'Nobody compares the names.'
"""


def test_what_students_get_holds_the_same_and_shows_no_answer(tmp_path: Path) -> None:
    (tmp_path / FILE).write_text(ONE)
    (tmp_path / SEALED).write_bytes(seal(ONE.encode()))
    assert read_questions(str(tmp_path / SEALED)) == read_questions(str(tmp_path / FILE))
    assert b'warning' not in (tmp_path / SEALED).read_bytes() and b'right' not in (tmp_path / SEALED).read_bytes()


def test_what_an_update_brought_wins_over_an_older_open_file(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    assert questions_file(str(tmp_path)) is None
    (tmp_path / FILE).write_text(ONE)
    (tmp_path / SEALED).write_bytes(seal(ONE.replace('two-names', 'new').encode()))
    monkeypatch.chdir(tmp_path)
    assert list(find_questions().questions) == ['new']


def test_they_are_found_in_the_folder_of_lessons_below(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / 'lessons').mkdir()
    (tmp_path / 'lessons' / FILE).write_text(ONE)
    monkeypatch.chdir(tmp_path)
    assert list(find_questions().explanations) == ['why-a-warning']


def test_answers_are_in_the_folder_of_solutions_and_not_beside_the_lessons(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / 'lessons').mkdir()
    (tmp_path / 'solutions').mkdir()
    (tmp_path / 'solutions' / FILE).write_text(ONE)
    for folder in (tmp_path, tmp_path / 'lessons'):
        monkeypatch.chdir(folder)
        assert list(find_questions().questions) == ['two-names']
    assert not list((ROOT / 'lessons').glob('*questions*')) and (ROOT / 'solutions' / FILE).is_file()


@pytest.mark.parametrize(
    ('change', 'put', 'named'),
    [
        ("right = 'b'", "right = 'x'", 'has no right choice'),
        ("right = 'b'", 'right = 2', 'has no right choice'),
        ("lesson = '01_first_launch'\ntext", 'text', "lacks 'lesson'"),
        ('choices', 'choice', "lacks 'choices'"),
        ('[[question]]', '[[question', 'cannot read the questions'),
        ('answer =', 'answers =', 'the explanation "why-a-warning" lacks \'answer\''),
    ],
)
def test_a_mistake_in_the_file_is_named(tmp_path: Path, change: str, put: str, named: str) -> None:
    (tmp_path / FILE).write_text(ONE.replace(change, put))
    with pytest.raises(UnusableInput, match=named):
        read_questions(str(tmp_path / FILE))
