"""An explanation is written before the answer is shown, and kept."""

from __future__ import annotations

from pathlib import Path

import pytest
from edugrade.progress_file import ProgressFile

from edulaunch.course import explain
from tests.course.test_questions import ONE


@pytest.fixture(autouse=True)
def _in_a_course(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / 'questions.toml').write_text(ONE)
    monkeypatch.chdir(tmp_path)


@pytest.mark.parametrize('text', [..., '', 'no', 'I do not'])
def test_the_answer_is_hidden_until_something_is_written(text: str) -> None:
    assert 'compares' not in repr(explain('why-a-warning', text))
    assert ProgressFile('.').explanations == {}


def test_what_was_written_is_kept_and_shown_beside_the_answer() -> None:
    shown = explain(
        'why-a-warning',
        """Launch starts what I
        write, <b>twice</b>.""",
    )
    assert shown.lines == ['You wrote: Launch starts what I write, <b>twice</b>.', 'Answer: Nobody compares the names.']
    assert '<b>' not in shown._repr_html_()
    assert ProgressFile('.').explanations == {'why-a-warning': 'Launch starts what I write, <b>twice</b>.'}
    explain('why-a-warning', 'Nobody looks at the names.')
    assert ProgressFile('.').explanations == {'why-a-warning': 'Nobody looks at the names.'}


def test_an_unknown_name_names_the_nearest() -> None:
    assert "did you mean explain('why-a-warning', ...)?" in repr(explain('why_warning', 'because of the names'))
