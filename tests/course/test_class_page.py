"""A page on a class: where each student is, what is hard, who is stuck."""

from __future__ import annotations

from pathlib import Path

import pytest
from edugrade.course import Exercise

from edulaunch.course.class_page import Class, is_stuck, page_of_class, place_of
from edulaunch.course.handed_in import Done, Refused, Standing
from edulaunch.course.questions import Choice, Question
from edulaunch.desk.cli.main import main

EXERCISES = [Exercise(f'{name}.launch.py', name.title(), 'lesson', 12, ()) for name in ('first', 'second', 'third')]
QUESTION = Question('q', 'lesson', 'What is two?', (Choice('one', ''), Choice('two', '')), 'b')
DONE = Done(True, 1, 0, 12.0)
ANNA = Standing('anna', {'first': DONE, 'second': Done(False, 6, 2, 3.0)}, {'q': ['a', 'b']})
BERT = Standing('bert', {'first': Done(True, 2), 'second': DONE, 'third': DONE}, {'q': ['b']})
CARL = Standing('<script>carl</script>', {'second': DONE}, {})
KNOWN = Class(EXERCISES, [QUESTION], [ANNA, BERT, CARL], [Refused('mallory/my_progress.toml', 'it is not TOML')])


def test_where_somebody_is_follows_the_order_of_the_course() -> None:
    assert [place_of(KNOWN, student) for student in (ANNA, BERT, CARL)] == ['second', 'all done', 'third']
    assert place_of(KNOWN, Standing('dora', {}, {})) == 'first'
    assert place_of(KNOWN, Standing('emil', {'third': DONE}, {})) == 'first'


def test_who_tried_often_and_has_not_done_it_is_stuck() -> None:
    assert [is_stuck(each) for each in (Done(False, 4), Done(False, 3), Done(True, 9), Done())] == [True, False, False, False]


def test_the_page_says_who_is_stuck_what_is_hard_and_what_could_not_be_read() -> None:
    page = page_of_class(KNOWN)
    assert '<td>anna</td><td>Second</td><td>6</td><td>2</td><td>3 of 12</td>' in page
    assert page.index('<td>Second</td><td>lesson</td><td>3</td><td>1</td><td>1</td><td>1</td>') < page.index('<td>First</td>')
    assert '<td>What is two?</td><td>1 of 2</td><td>a) one</td>' in page
    assert 'mallory/my_progress.toml: it is not TOML' in page
    assert '<td class="stuck">6!</td>' in page and '<td class="done">✓2</td>' in page


def test_nothing_that_a_student_wrote_is_markup_and_the_page_loads_nothing() -> None:
    page = page_of_class(KNOWN)
    assert '<script' not in page and '&lt;script&gt;carl' in page
    assert 'default-src &#x27;none&#x27;' in page


def test_the_command_writes_the_page_and_names_what_it_left_out(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    for name, text in (('anna', '[circle]\ndone = true\nattempts = 1\n'), ('mallory', '[circle')):
        (tmp_path / name).mkdir()
        (tmp_path / name / 'my_progress.toml').write_text(text)
    out = tmp_path / 'page.html'
    assert main(['course', 'class', str(tmp_path), '--out', str(out)]) == 1
    told = capsys.readouterr()
    assert told.out == f'{out}: 1 student. Open it in a browser\n'
    assert told.err == 'skipped mallory/my_progress.toml: it is not TOML\n'
    assert '<th scope="row">anna</th>' in out.read_text()
    (tmp_path / 'mallory' / 'my_progress.toml').unlink()
    assert main(['course', 'class', str(tmp_path), '--out', str(out)]) == 0
    assert main(['course', 'class', str(tmp_path / 'anna' / 'none'), '--out', str(out)]) == 2
