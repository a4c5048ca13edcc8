"""A prediction is kept and compared."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from edugrade.progress_file import NAME, ProgressFile
from hypothesis import given
from hypothesis import strategies as st

from edulaunch.course import compare, predict
from edulaunch.course.predictions import _numbers, _text


@pytest.fixture(autouse=True)
def _in_a_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)


def test_what_was_said_is_put_beside_what_was() -> None:
    assert repr(predict('square-end', (7.5, 5.5))) == 'Stored: (7.5, 5.5). Now run the next cell.'
    assert repr(compare('square-end', (5.5, 5.5))) == 'You predicted (7.5, 5.5), the result is (5.5, 5.5): 2 off.'


def test_three_dots_are_no_guess_and_nothing_is_written() -> None:
    assert 'No prediction yet' in repr(predict('square-end', ...))
    assert not Path(NAME).exists()
    assert repr(compare('square-end', 3)).startswith('The result is 3. You made no prediction')


@pytest.mark.parametrize(
    ('said', 'was', 'told'),
    [
        (4, 4.0, 'You predicted 4, the result is 4: exactly.'),
        ('/sim', '/sim', 'You predicted /sim, the result is /sim: right.'),
        ('Error', 'error', 'You predicted Error, the result is error: right.'),
        ('an error', 255, 'You predicted an error, the result is 255.'),
        (True, False, 'You predicted True, the result is False.'),
        (3, (1, 2), 'You predicted 3, the result is (1, 2): write 2 numbers.'),
        ((3, 4), 5, 'You predicted (3, 4), the result is 5: write one number.'),
        ((0, 0), np.array([3.0, 4.0]).tolist(), 'You predicted (0, 0), the result is (3, 4): 5 off.'),
        (1, np.float64(1.5), 'You predicted 1, the result is 1.5: 0.5 off.'),
        ('a\x07b\ud800', 'x', 'You predicted a?b?, the result is x.'),
    ],
)
def test_verdicts(said: object, was: object, told: str) -> None:
    predict('it', said)
    assert repr(compare('it', was)) == told


def test_the_last_word_counts_and_exercises_stay() -> None:
    file = ProgressFile('.')
    file.of('circle').attempt(3, 12, False)
    file.save()
    predict('it', 1)
    predict('it', 2)
    again = ProgressFile('.')
    assert again.predictions == {'it': '2'} and again.exercises['circle'].attempts == 1


def test_a_file_that_nobody_can_write_costs_no_answer() -> None:
    Path(NAME).mkdir()
    assert 'Your answer is not kept: ' in repr(predict('it', 1))


def test_html_holds_no_markup_of_the_student() -> None:
    assert '<b>' not in predict('it', '<b>')._repr_html_() and '&lt;b&gt;' in predict('it', '<b>')._repr_html_()


@pytest.mark.parametrize('said', ['no', 'No.', ' NO!'])
def test_words_are_right_whatever_ends_them(said: str) -> None:
    predict('word', said)
    assert repr(compare('word', 'no')).endswith(': right.')


@given(st.lists(st.floats(allow_nan=False, allow_infinity=False), min_size=1, max_size=3))
def test_numbers_survive_their_text(numbers: list[float]) -> None:
    found = _numbers(_text(tuple(numbers)))
    assert found == [float(f'{number:.4g}') for number in numbers]
