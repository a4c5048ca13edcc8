"""Questions with choices: shown, answered, kept; readable in a saved notebook."""

from __future__ import annotations

from pathlib import Path

import pytest
from edugrade.progress_file import ProgressFile

from edulaunch.course import quiz
from tests.course.test_questions import ONE


@pytest.fixture(autouse=True)
def _in_a_course(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / 'questions.toml').write_text(ONE)
    (tmp_path / 'deep').mkdir()
    monkeypatch.chdir(tmp_path / 'deep')


def test_a_question_says_how_to_answer() -> None:
    asked = repr(quiz('two-names', ...))
    assert asked == (
        'Two nodes of one name: what happens?\n  a) The second one is refused.\n  b) Both run, and tools mix them up.\n'
        "To answer, replace the three dots: quiz('two-names', 'a'), or another letter. Then run the cell again."
    )
    assert repr(quiz('two-names')) == asked


def test_an_answer_shows_choices_and_comment_and_is_kept() -> None:
    assert repr(quiz('two-names', 'A')) == (
        'Two nodes of one name: what happens?\n* a) The second one is refused.\n  b) Both run, and tools mix them up.\n'
        'Not quite. ROS 2 starts both.'
    )
    assert repr(quiz('two-names', 'b)')).endswith('Right. A warning is all you get.')
    assert ProgressFile('.').answers == {'two-names': ['a', 'b']}


def test_a_saved_notebook_shows_it_without_a_kernel() -> None:
    html = quiz('two-names', 'b')._repr_html_()
    assert (
        '<b>b) Both run, and tools mix them up. (your answer)</b>' in html
        and 'a) The second one' in html
        and 'Right. A warning is all you get.' in html
    )
    assert 'A warning' not in quiz('two-names', ...)._repr_html_(), 'no comment before an answer'
    for shown in (quiz('two-names', ...), quiz('two-names', 'a')):
        assert not hasattr(shown, '_repr_mimebundle_') and 'script' not in shown._repr_html_()


@pytest.mark.parametrize('choice', ['c', '', 'ab', 7])
def test_another_letter_is_refused_and_not_kept(choice: str) -> None:
    assert 'is not one of the choices: a, b.' in repr(quiz('two-names', choice))
    assert ProgressFile('.').answers == {}


def test_an_unknown_question_names_the_nearest() -> None:
    assert "did you mean quiz('two-names', ...)?" in repr(quiz('two_name'))
