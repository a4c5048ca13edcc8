"""Runs that a secret chooses: the same for the same student and text, others for all others."""

from __future__ import annotations

from pathlib import Path

import pytest
from edugrade.grading import plan_work
from edugrade.submission import Submission
from edugrade.variant import CourseSecret

from edulaunch.errors import UnusableInput

CIRCLE = Path(__file__).parents[2] / 'solutions' / 'circle.launch.py'


@pytest.fixture
def secret(tmp_path: Path) -> CourseSecret:
    (tmp_path / 'secret').write_text('0123456789abcdef\n')
    return CourseSecret(str(tmp_path / 'secret'))


def test_student_text_exercise_and_secret_choose(secret: CourseSecret, tmp_path: Path) -> None:
    (tmp_path / 'other').write_text('0123456789abcdeX')
    seeds = [
        secret.seed('circle', 'anna', 'f00d'),
        secret.seed('circle', 'bert', 'f00d'),
        secret.seed('circle', 'anna', 'beef'),
        secret.seed('follow', 'anna', 'f00d'),
        CourseSecret(str(tmp_path / 'other')).seed('circle', 'anna', 'f00d'),
    ]
    assert len(set(seeds)) == 5
    assert secret.seed('circle', 'anna', 'f00d') == seeds[0]


def test_the_runs_follow(secret: CourseSecret) -> None:
    anna, bert = (plan_work(Submission(str(CIRCLE)), secret=secret, student=name) for name in ('anna', 'bert'))
    assert anna.secret == secret.name and '0123' not in secret.name
    assert [run.arguments for run in anna.scenarios] != [run.arguments for run in bert.scenarios]
    assert len({run.seed for run in (*anna.scenarios, *bert.scenarios)}) == 4


@pytest.mark.parametrize('text', ['', 'short', None])
def test_what_is_no_secret_is_an_error(tmp_path: Path, text: str | None) -> None:
    if text is not None:
        (tmp_path / 'secret').write_text(text)
    with pytest.raises(UnusableInput, match='course secret'):
        CourseSecret(str(tmp_path / 'secret'))
