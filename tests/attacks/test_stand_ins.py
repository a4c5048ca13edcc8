"""What stands in for the measured behaviour is not paid. One batch of gradings, confined as a course's are."""

from __future__ import annotations

import shutil
from collections.abc import Iterator
from pathlib import Path

import pytest
from edugrade.grading import grade, plan_work
from edugrade.results import Report
from edugrade.submission import Submission

from tests.attacks.package_stand_ins import PACKAGES
from tests.attacks.stand_ins import STAND_INS
from tests.house import ROOT

pytestmark = pytest.mark.attacks
MOST = {name: attack.most for name, attack in (*STAND_INS.items(), *PACKAGES.items())}


def written(folder: Path) -> Iterator[Path]:
    for number, attack in enumerate(STAND_INS.values()):
        file = folder / f'file{number}' / f'{attack.exercise}.launch.{"xml" if attack.text.startswith("<") else "py"}'
        file.parent.mkdir()
        file.write_text(attack.text)
        yield file
    for number, package in enumerate(PACKAGES.values()):
        place = folder / f'package{number}' / package.exercise
        shutil.copytree(ROOT / 'solutions' / package.exercise, place, ignore=shutil.ignore_patterns('__pycache__'))
        for path, text in package.files.items():
            assert not (place / path).exists() or (place / path).read_text() != text
            (place / path).write_text(text)
        yield place


@pytest.fixture(scope='module')
def graded(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Report]:
    works = [plan_work(Submission(str(path))) for path in written(tmp_path_factory.mktemp('stand_ins'))]
    return dict(zip(MOST, grade(works), strict=True))


@pytest.mark.parametrize('name', MOST)
def test_only_the_honest_rest_is_paid(graded: dict[str, Report], name: str) -> None:
    told = [f'{result.name}: {result.status} {result.earned} {result.reason} {result.seen}' for result in graded[name].results]
    assert graded[name].earned == MOST[name], told
