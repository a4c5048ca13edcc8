"""Runs are begun in the starter, and it tells what became of them."""

from __future__ import annotations

import os
from collections.abc import Iterator
from pathlib import Path

import pytest
from edugrade import Scenario
from edugrade.job import Job
from edugrade.limits import Limits
from edugrade.starter_link import StarterLink
from edugrade.submission import Submission


@pytest.fixture
def link(tmp_path: Path) -> Iterator[StarterLink]:
    starter = StarterLink(str(tmp_path))
    yield starter
    starter.close()


def begin(link: StarterLink, folder: Path, text: str, number: int) -> int:
    """Begin a run; gives the end on which it can be heard."""
    (folder / 'a.launch.py').write_text(text)
    heard, channel = os.pipe()
    job = Job(Submission(str(folder / 'a.launch.py')), Scenario('s'), Limits(5.0), [], str(folder))
    link.begin(number, job, channel, channel)
    os.close(channel)
    return heard


def test_a_run_is_a_process_that_answers_and_whose_end_is_told(link: StarterLink, tmp_path: Path) -> None:
    heard = begin(link, tmp_path, 'import posix\nposix.write(1, b"here")\nposix._exit(3)\n', 4)
    pid = link.pid_of(4)
    assert os.read(heard, 100) == b'here'
    while 4 not in link.statuses:
        link.hear()
    assert (pid, link.statuses[4]) == (link.pids[4], 3)
    os.close(heard)


def test_without_a_starter_there_is_no_process(link: StarterLink, tmp_path: Path) -> None:
    os.close(begin(link, tmp_path, '', 1))
    pid = link.pid_of(1)
    link.close()
    assert pid is not None
    link.hear()
    assert (link.is_alive, link.pid_of(2)) == (False, None)
    os.close(begin(link, tmp_path, '', 3))
    assert 3 not in link.pids
