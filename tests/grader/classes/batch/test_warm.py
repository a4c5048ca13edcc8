"""A worker's grader grades many submissions, and loads the engine once."""

from __future__ import annotations

import os
import signal
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from edugrade.classes.batch import warm
from edugrade.classes.batch.warm import Lost, WarmProcess, ask_warm
from edugrade.rubrics.catalogue import rubrics_folder

from edulaunch.errors import UnusableInput

pytestmark = pytest.mark.processes
SOLUTION = Path(__file__).parents[4] / 'solutions' / 'static_frame.launch.py'
PATIENCE_S = 300.0


@pytest.fixture(autouse=True)
def none_is_left() -> Iterator[None]:
    yield
    while warm._idle:
        warm._idle.pop().close()


def request(file: Path, **changes: Any) -> dict[str, Any]:
    rubric = os.path.join(rubrics_folder(), 'static_frame.py')
    usual = {'seed': 3, 'limit': 30.0, 'sandbox': 'auto', 'only': None, 'page': False, 'replays': False, 'workspaces': []}
    return {'file': str(file), 'rubric': rubric, **usual, **changes}


def starters(process: WarmProcess) -> list[str]:
    """The pids of the starters that a grader has now."""
    return Path(f'/proc/{process._process.pid}/task/{process._process.pid}/children').read_text().split()


def test_one_starter_serves_many_submissions_and_reports_are_equal() -> None:
    first = ask_warm(request(SOLUTION), PATIENCE_S)
    (process,) = warm._idle
    before = starters(process)
    second = ask_warm(request(SOLUTION), PATIENCE_S)
    assert first['report'] == second['report'] and first['report']['points']['earned'] == 12
    assert warm._idle == [process] and starters(process) == before and len(before) == 1


def test_what_cannot_be_graded_is_said_and_the_grader_stays(tmp_path: Path) -> None:
    with pytest.raises(UnusableInput, match='does not exist'):
        ask_warm(request(tmp_path / 'static_frame.launch.py'), PATIENCE_S)
    assert len(warm._idle) == 1


def test_a_grader_that_was_killed_is_replaced() -> None:
    ask_warm(request(SOLUTION), PATIENCE_S)
    (process,) = warm._idle
    os.kill(process._process.pid, signal.SIGKILL)
    with pytest.raises(Lost):
        ask_warm(request(SOLUTION), PATIENCE_S)
    assert warm._idle == []
    assert ask_warm(request(SOLUTION), PATIENCE_S)['report']['points']['earned'] == 12


def test_other_limits_make_another_runner() -> None:
    ask_warm(request(SOLUTION), PATIENCE_S)
    (process,) = warm._idle
    before = starters(process)
    ask_warm(request(SOLUTION, limit=20.0), PATIENCE_S)
    assert starters(process) != before
