"""Questions with choices."""

from __future__ import annotations

from pathlib import Path

import pytest
from edugrade.progress_file import ProgressFile

from edulaunch.course import quiz
from edulaunch.course.quizzes import read_questions
from edulaunch.errors import UnusableInput

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
"""


@pytest.fixture(autouse=True)
def _in_a_course(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / 'questions.toml').write_text(ONE)
    (tmp_path / 'deep').mkdir()
    monkeypatch.chdir(tmp_path / 'deep')


def test_a_question_is_text_that_says_how_to_answer() -> None:
    assert repr(quiz('two-names')) == (
        'Two nodes of one name: what happens?\n  a) The second one is refused.\n  b) Both run, and tools mix them up.\n'
        "Answer with quiz('two-names', 'a'), or another letter."
    )


def test_an_answer_is_judged_explained_and_kept() -> None:
    assert repr(quiz('two-names', 'A')) == 'Not quite. ROS 2 starts both.'
    assert repr(quiz('two-names', 'b)')) == 'Right. A warning is all you get.'
    assert ProgressFile('.').answers == {'two-names': ['a', 'b']}


@pytest.mark.parametrize('choice', ['c', '', 'ab', 7])
def test_no_such_choice_is_told_and_not_kept(choice: str) -> None:
    assert 'is none of the choices: a, b.' in repr(quiz('two-names', choice))
    assert ProgressFile('.').answers == {}


def test_an_unknown_question_names_the_nearest() -> None:
    assert "did you mean quiz('two-names')?" in repr(quiz('two_name'))


def test_a_click_says_and_keeps_the_same(monkeypatch: pytest.MonkeyPatch) -> None:
    widgets = pytest.importorskip('ipywidgets')
    made: list[object] = []
    monkeypatch.setattr('ipywidgets.VBox._repr_mimebundle_', lambda self, **_: made.append(self) or {'text/plain': 'VBox'})
    bundle = quiz('two-names')._repr_mimebundle_()
    assert bundle['text/plain'].startswith('Two nodes')
    text, row, told = made[0].children  # type: ignore[attr-defined]
    assert [button.description for button in row.children] == ['a', 'b'] and isinstance(text, widgets.HTML)
    row.children[1].click()
    assert 'Right. A warning' in told.value and ProgressFile('.').answers == {'two-names': ['b']}


@pytest.mark.parametrize(
    ('change', 'told'),
    [
        ("right = 'b'", 'has no right choice'),
        ("lesson = '01_first_launch'\n", "lacks 'lesson'"),
        ('choices', "lacks 'choices'"),
        ('[[question]]', 'cannot be read'),
    ],
)
def test_a_mistake_in_the_file_is_named(tmp_path: Path, change: str, told: str) -> None:
    put = {"right = 'b'": "right = 'x'", 'choices': 'choice', '[[question]]': '[[question'}.get(change, '')
    (tmp_path / 'questions.toml').write_text(ONE.replace(change, put))
    with pytest.raises(UnusableInput, match=told):
        read_questions(str(tmp_path / 'questions.toml'))
