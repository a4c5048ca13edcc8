"""Solutions with one edit, run and graded: each mistake costs what it breaks, and unusual right answers get all points."""

from __future__ import annotations

import shutil
from collections.abc import Iterator
from pathlib import Path

import pytest
from edits import EDITS, Edit
from edugrade.grading import grade, plan_work
from edugrade.job import Limits
from edugrade.results import Report
from edugrade.submission import Submission

from tests.house import ROOT

pytestmark = pytest.mark.whole
SOLUTIONS = ROOT / 'solutions'


def edited(folder: Path) -> Iterator[Path]:
    for number, (name, edit) in enumerate(EDITS.items()):
        exercise = name.partition(':')[0]
        place = folder / str(number)
        if edit.file:
            shutil.copytree(SOLUTIONS / exercise, place / exercise, ignore=shutil.ignore_patterns('__pycache__'))
            write(place / exercise / edit.file, edit)
            yield place / exercise
        else:
            (solution,) = SOLUTIONS.glob(f'{exercise}.launch.*')
            place.mkdir()
            shutil.copy(solution, place)
            write(place / solution.name, edit)
            yield place / solution.name


def write(file: Path, edit: Edit) -> None:
    text = file.read_text()
    assert edit.old in text
    file.write_text(text.replace(edit.old, edit.new) if edit.old else edit.new)


@pytest.fixture(scope='module')
def graded(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Report]:
    works = [plan_work(Submission(str(path))) for path in edited(tmp_path_factory.mktemp('edits'))]
    return dict(zip(EDITS, grade(works, Limits(600.0)), strict=True))


@pytest.mark.parametrize('name', EDITS)
def test_an_edit_costs_what_it_breaks(graded: dict[str, Report], name: str) -> None:
    told = [f'{result.name}: {result.status} {result.earned} {result.reason} {result.seen}' for result in graded[name].results]
    assert graded[name].earned == EDITS[name].points, told
