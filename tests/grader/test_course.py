"""Exercises, solutions, rubrics and manifest belong together, file by file."""

from __future__ import annotations

from difflib import SequenceMatcher
from pathlib import Path
from statistics import median

import pytest
from edugrade.catalogue import exercises, find_rubric
from edugrade.cli import main
from edugrade.hints import LEVELS, read_course
from edugrade.source import Source
from edugrade.submission import exercise_of

REPOSITORY = Path(__file__).resolve().parents[2]
STUBS, SOLUTIONS = REPOSITORY / 'exercises', REPOSITORY / 'solutions'
COURSE = read_course(str(STUBS / 'course.toml'))
NAMES = [entry['file'] for entry in COURSE]


def files_of(folder: Path) -> list[str]:
    found = (path.relative_to(folder).as_posix() for path in folder.rglob('*') if path.is_file())
    return sorted(name for name in found if '__pycache__' not in name and name != 'course.toml')


def gaps_of(folder: Path, name: str) -> list[tuple[int, str]]:
    return Source(name, (folder / name).read_text()).gaps


def added_lines(name: str) -> int:
    """Lines of the solution that the stub lacks, its opening text and imports left out."""
    stub, solution = (
        (folder / name).read_text().split('def generate_launch_description', 1)[1].splitlines()
        for folder in (STUBS, SOLUTIONS)
    )
    return sum(
        b2 - b1
        for _, _, _, b1, b2 in (
            code for code in SequenceMatcher(None, stub, solution).get_opcodes() if code[0] != 'equal'
        )
    )


def test_stubs_and_solutions_have_the_paths_of_the_manifest_and_no_others() -> None:
    assert files_of(STUBS) == files_of(SOLUTIONS) == sorted(NAMES)


def test_every_exercise_has_a_rubric_and_every_rubric_an_exercise() -> None:
    assert sorted(exercise_of(name) for name in NAMES) == exercises()


@pytest.mark.parametrize('entry', COURSE, ids=NAMES)
def test_the_manifest_is_complete(entry: dict[str, object]) -> None:
    assert sorted(entry) == ['file', 'hints', 'lesson', 'points', 'title']
    hints = entry['hints']
    assert isinstance(hints, list)
    assert len(hints) == LEVELS
    assert all(isinstance(hint, str) and len(hint) > 40 for hint in hints)


@pytest.mark.parametrize('entry', COURSE, ids=NAMES)
def test_title_and_points_are_those_of_the_rubric(entry: dict[str, object]) -> None:
    rubric = find_rubric(exercise_of(str(entry['file'])))[1]
    assert (entry['title'], entry['points']) == (rubric.title, sum(check.points for check in rubric.checks))


@pytest.mark.parametrize('name', NAMES)
def test_a_stub_has_one_to_three_gaps_and_its_solution_none(name: str) -> None:
    assert 1 <= len(gaps_of(STUBS, name)) <= 3
    assert gaps_of(SOLUTIONS, name) == []


def test_gaps_are_small() -> None:
    assert median(added_lines(name) / len(gaps_of(STUBS, name)) for name in NAMES) <= 10


@pytest.mark.parametrize('name', NAMES)
def test_a_solution_passes_everything(name: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main([str(SOLUTIONS / name)]) == 0
    assert 'FAILED' not in capsys.readouterr().out


@pytest.mark.parametrize('name', NAMES)
def test_a_stub_fails_and_its_first_gap_is_named(name: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main([str(STUBS / name)]) == 1
    line = gaps_of(STUBS, name)[0][0]
    assert f'Next: fill in line {line} of ' in capsys.readouterr().out
