"""Every test of this folder runs once for each lesson, or walks through one."""

from __future__ import annotations

import gc
import shutil
import threading
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from tests.lessons.notebook import LESSONS, ORDER, Lesson, Walk
from tests.lessons.student import leave

WAIT_S = 60.0
"""A watchdog looks whether it may go a few times a second; nothing is measured by this."""


@pytest.fixture(params=ORDER, scope='module')
def lesson(request: pytest.FixtureRequest) -> Lesson:
    """Each lesson."""
    return Lesson(request.param)


@pytest.fixture
def walk(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Callable[[str], Walk]:
    """Begin a walk through a lesson in a fresh folder: walk('10_carrots')."""

    def begin(name: str) -> Walk:
        monkeypatch.setenv('USER', 'student')
        for folder in ('checkpoints', 'checks'):
            shutil.copytree(LESSONS / folder, tmp_path / folder)
        return Walk(Lesson(name), tmp_path)

    return begin


@pytest.fixture(autouse=True)
def no_notebook_is_left() -> Iterator[None]:
    """An IPython that a test has made is gone after it: whoever finds one takes the program for a notebook."""
    yield
    leave()


@pytest.fixture(autouse=True, scope='module')
def no_threads_are_left() -> Iterator[None]:
    """A few hundred tests later, threads that are left take most of the time."""
    before = {*threading.enumerate()}
    yield
    names = ('IPython', 'edulaunch watchdog')
    left = [thread for thread in threading.enumerate() if thread not in before and thread.name.startswith(names)]
    gc.collect()  # a machine that no notebook uses any more stops its watchdog when it is collected
    for thread in left:
        thread.join(timeout=WAIT_S)
    assert not [thread for thread in left if thread.is_alive()], left
