"""Decoys of all solutions: what keeps names and drops behaviour gets no more than its rubric allows."""

from __future__ import annotations

from pathlib import Path

import pytest
from edugrade.course import read_course
from edugrade.decoys.command import Paid, pay

pytestmark = pytest.mark.attacks
ROOT = Path(__file__).resolve().parents[2]
COURSE = [item.name for item in read_course(str(ROOT / 'exercises' / 'course.toml'))]
KINDS = ('replay', 'swapped', 'own programs')  # a replay has the names, too


@pytest.fixture(scope='module')
def paid() -> dict[str, list[Paid]]:
    found: dict[str, list[Paid]] = {name: [] for name in COURSE}
    for one in pay(str(ROOT), kinds=KINDS):
        found[one.exercise].append(one)
    return found


def test_there_are_decoys_of_all_exercises(paid: dict[str, list[Paid]]) -> None:
    assert len(COURSE) >= 26 and all(len(kinds) >= 1 for kinds in paid.values())
    assert sum(len(kinds) for kinds in paid.values()) >= 50


@pytest.mark.parametrize('name', COURSE)
def test_a_decoy_gets_no_more_than_its_rubric_allows(paid: dict[str, list[Paid]], name: str) -> None:
    for one in paid[name]:
        assert one.share <= one.most, one
