"""Real submissions, run and graded: unusual right answers get all points, near misses and claims do not, small faults cost what they break."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

import pytest
from edugrade.grading import grade, plan_work
from edugrade.job import Limits
from edugrade.results import CheckResult
from edugrade.submission import Submission
from near_misses import WRONG, WRONG_PACKAGES
from right import RIGHT, RIGHT_PACKAGES
from small_faults import FAULTS

pytestmark = pytest.mark.whole  # ninety submissions that are run

ALL_RIGHT = [*RIGHT, *RIGHT_PACKAGES]
ALL_WRONG = {**{name: case[1] for name, case in WRONG.items()}, **{name: case[0] for name, case in WRONG_PACKAGES.items()}}


def written(folder: Path) -> Iterator[tuple[str, Path]]:
    """Every case as files, by its name."""
    launch_files = RIGHT | {name: (case[0], '', case[2]) for name, case in WRONG.items()}
    for number, (name, (exercise, ending, text)) in enumerate(launch_files.items()):
        file = folder / str(number) / f'{exercise}.launch.{ending or "py"}'
        file.parent.mkdir()
        file.write_text(text)
        yield name, file
    for name, (exercise, _, text) in FAULTS.items():
        file = folder / name.replace(': ', '-').replace(' ', '_') / f'{exercise}.launch.{"xml" if text.startswith("<") else "py"}'
        file.parent.mkdir()
        file.write_text(text)
        yield name, file
    packages = RIGHT_PACKAGES | {name: case[1] for name, case in WRONG_PACKAGES.items()}
    for number, (name, files) in enumerate(packages.items(), len(launch_files)):
        for path, text in files.items():
            file = folder / str(number) / 'large_project' / path
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(text)
        yield name, folder / str(number) / 'large_project'


class Graded(NamedTuple):
    """What stays of a report. The recordings of all of them would need 700 MB, and each later fork of this process would copy their pages' table."""

    earned: float | None
    results: tuple[CheckResult, ...]


@pytest.fixture(scope='module')
def graded(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Graded]:
    cases = dict(written(tmp_path_factory.mktemp('submissions')))
    works = [plan_work(Submission(str(path))) for path in cases.values()]
    reports = (Graded(report.earned, report.results) for report in grade(works, Limits(600.0)))  # a busy machine takes its time
    return dict(zip(cases, reports, strict=True))


def test_there_are_enough_of_both_for_every_exercise() -> None:
    exercises = {'circle', 'static_frame', 'follow', 'carrot', 'broken_follow', 'large_project'}
    assert len(ALL_RIGHT) >= 40 and {name.partition(':')[0] for name in ALL_RIGHT} >= exercises
    assert len(FAULTS) >= 30 and len({case[0] for case in FAULTS.values()}) >= 15
    assert len(ALL_WRONG) >= 40 and {name.partition(':')[0] for name in ALL_WRONG} == exercises


@pytest.mark.parametrize('name', ALL_RIGHT)
def test_an_unusual_right_answer_gets_all_points(graded: dict[str, Graded], name: str) -> None:
    report = graded[name]
    assert (
        report.earned,
        [f'{result.sentence}: {result.reason}; seen: {result.seen}' for result in report.results if result.reason],
    ) == (12, [])


@pytest.mark.parametrize('name', ALL_WRONG)
def test_a_near_miss_does_not(graded: dict[str, Graded], name: str) -> None:
    report = graded[name]
    (result,) = [result for result in report.results if result.name == ALL_WRONG[name]]
    assert (result.earned, result.status in ('failed', 'not_run')) == (0, True), result
    assert report.earned is not None and report.earned < 12
    assert report.results[0].status == 'passed', report.results[0].reason


@pytest.mark.parametrize('name', FAULTS)
def test_a_small_fault_costs_what_it_breaks(graded: dict[str, Graded], name: str) -> None:
    results = graded[name].results
    lost = [result.name for result in results if result.points and result.earned != result.points]
    assert tuple(lost) == FAULTS[name][1], [f'{result.name}: {result.status} {result.reason} {result.seen}' for result in results]
