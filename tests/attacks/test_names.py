"""Names without behaviour get what the rest of the file deserves. One batch of gradings, confined as a course's are."""

from __future__ import annotations

import pytest
from edugrade.grading import grade, plan_work
from edugrade.results import Report
from edugrade.submission import Submission

from tests.attacks.forgeries import FORGERIES
from tests.attacks.names import NAMES

pytestmark = pytest.mark.attacks
ATTACKS = NAMES | FORGERIES


@pytest.fixture(scope='module')
def graded(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Report]:
    folder, works = tmp_path_factory.mktemp('names'), []
    for number, attack in enumerate(ATTACKS.values()):
        file = folder / str(number) / f'{attack.exercise}.launch.{"xml" if attack.text.startswith("<") else "py"}'
        file.parent.mkdir()
        file.write_text(attack.text)
        works.append(plan_work(Submission(str(file))))
    return dict(zip(ATTACKS, grade(works), strict=True))


@pytest.mark.parametrize('name', ATTACKS)
def test_names_earn_what_the_rest_deserves(graded: dict[str, Report], name: str) -> None:
    report = graded[name]
    told = [f'{result.name}: {result.status} {result.earned} {result.reason}' for result in report.results]
    assert report.earned is not None, told
    assert report.earned <= ATTACKS[name].most, told
