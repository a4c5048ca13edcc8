"""Runs are begun in the starter, and a guard tells what became of each."""

from __future__ import annotations

import json
import os
import socket
from collections.abc import Iterator
from pathlib import Path

import pytest
from edugrade import Scenario
from edugrade.job import Limits, RunRequest
from edugrade.starter_link import StarterLink
from edugrade.submission import Submission

pytestmark = pytest.mark.processes


@pytest.fixture
def link(tmp_path: Path) -> Iterator[StarterLink]:
    starter = StarterLink(str(tmp_path))
    yield starter
    starter.close()


def begin(link: StarterLink, folder: Path, text: str) -> tuple[int, socket.socket]:
    """Begin a run; gives the end on which it can be heard, and the link to its guard."""
    (folder / 'a.launch.py').write_text(text)
    (folder / 'home').mkdir()
    heard, channel = (end.detach() for end in socket.socketpair())
    os.write(heard, b'H' + (2).to_bytes(8, 'big') + b'{}')  # what the submission must not know
    job = RunRequest(Submission(str(folder / 'a.launch.py')), Scenario('s'), Limits(5.0), [], str(folder / 'home'))
    guard = link.begin(job, channel, channel)
    os.close(channel)
    return heard, guard


def told(guard: socket.socket) -> list[dict[str, int]]:
    """What the guard says until it is gone."""
    with guard, guard.makefile() as lines:
        return [json.loads(line) for line in lines]


def test_a_run_is_confined_answers_and_its_end_is_told(link: StarterLink, tmp_path: Path) -> None:
    heard, guard = begin(link, tmp_path, 'import posix\nposix.write(1, b"here")\nposix._exit(3)\n')
    begun, ended = told(guard)
    with open(heard, 'rb') as file:
        data = file.read()
    assert (data[:1], data[-4:]) == (b'C', b'here')
    assert (begun['pid'] > 1, ended) == (True, {'status': 3})


def test_a_run_ends_when_its_guard_is_let_go(link: StarterLink, tmp_path: Path) -> None:
    heard, guard = begin(link, tmp_path, 'while True:\n    pass\n')
    pid = json.loads(guard.recv(1000))['pid']
    guard.shutdown(socket.SHUT_WR)
    assert told(guard) == [{}]
    assert not os.path.exists(f'/proc/{pid}')
    os.close(heard)


def test_without_a_starter_there_is_no_run(link: StarterLink, tmp_path: Path) -> None:
    link.close()
    heard, guard = begin(link, tmp_path, '')
    assert (link.is_alive, told(guard)) == (False, [])
    os.close(heard)
