"""Decoys of the lessons' turns: what keeps names and drops behaviour gets no more than the turn's rubric allows."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import pytest
from edugrade.decoys.command import Paid
from edugrade.rubrics.catalogue import load_rubric, rubrics_in

from tests.attacks.turn_decoys import rubric_file, turns_of
from tests.lessons.notebook import LESSONS, ORDER

pytestmark = pytest.mark.attacks
TURNS = [(lesson, cell, name) for lesson in ORDER for cell, name in turns_of(lesson)]


def test_every_turn_is_here() -> None:
    assert len(TURNS) >= 41 and {name for *_, name in TURNS} == set(rubrics_in(str(LESSONS / 'checks')))


def test_a_share_above_one_half_has_a_reason() -> None:
    """A comment beside it says which behaviour a decoy has."""
    for *_, name in TURNS:
        lines = [line for line in rubric_file(name).read_text().splitlines() if 'decoys' in line]
        assert all('#' in line for line in lines) and len(lines) == (load_rubric(str(rubric_file(name))).decoys > 0.5), name


@pytest.mark.parametrize(('lesson', 'cell', 'name'), TURNS, ids=[name for *_, name in TURNS])
def test_a_decoy_gets_no_more_than_the_turn_allows(tmp_path: Path, lesson: str, cell: str, name: str) -> None:
    command = [sys.executable, '-m', 'tests.attacks.turn_decoys', lesson, cell, name, str(tmp_path)]
    done = subprocess.run(command, capture_output=True, text=True, cwd=LESSONS.parent)
    assert done.returncode == 0, done.stderr[-2000:]
    lines = [line for line in done.stdout.splitlines() if line.startswith('["')]
    paid = [Paid(*json.loads(line)) for line in lines]
    assert paid or load_rubric(str(rubric_file(name))).names, 'only a turn about values has no decoys'
    for one in paid:
        assert one.share <= one.most, one
