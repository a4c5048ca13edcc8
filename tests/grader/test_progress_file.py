"""A student's progress is readable, and is never lost."""

from __future__ import annotations

import multiprocessing
from pathlib import Path

import pytest
from edugrade.progress_file import NAME, Progress, ProgressFile
from hypothesis import given, settings
from hypothesis import strategies as st

EXPECTED = """\
# My progress, kept by check(). It is mine: I may read it, copy it, and delete it to start over.

[circle]
done = false
attempts = 2
hints = [1, 3]
best_points = 7
points = 12
"""
MADE = st.builds(Progress, st.booleans(), st.integers(0, 99), st.lists(st.integers(1, 3)), st.integers(0), st.integers(0))


def test_the_file_can_be_read_by_a_person(tmp_path: Path) -> None:
    file = ProgressFile(str(tmp_path))
    for level in (3, 1, 3):
        file.of('circle').open_hint(level)
    file.of('circle').attempt(7, 12, False)
    file.of('circle').attempt(2, 12, False)
    file.save()
    assert (tmp_path / NAME).read_text() == EXPECTED


def test_what_was_done_once_stays_done() -> None:
    progress = Progress()
    progress.attempt(12, 12, True)
    progress.attempt(3, 12, False)
    assert (progress.done, progress.best_points, progress.attempts) == (True, 12, 2)


@settings(max_examples=15, deadline=None)
@given(st.dictionaries(st.text(st.characters(codec='utf-8', exclude_categories=('Cc',)), min_size=1), MADE))
def test_what_is_saved_is_read_again(tmp_path_factory: pytest.TempPathFactory, exercises: dict[str, Progress]) -> None:
    folder = str(tmp_path_factory.mktemp('progress'))
    file = ProgressFile(folder)
    file.exercises = exercises
    file.save()
    again = ProgressFile(folder)
    assert (again.exercises, again.word) == (exercises, '')


@pytest.mark.parametrize('text', ['[circle', 'circle = 1', '[circle]\ndone = 3', '[circle]\nother = 1', '\x00'])
def test_a_file_that_makes_no_sense_is_kept_and_said_so(tmp_path: Path, text: str) -> None:
    (tmp_path / NAME).write_text(text)
    file = ProgressFile(str(tmp_path))
    assert file.exercises == {}
    assert file.word.startswith('my_progress.toml could not be understood (')
    assert (tmp_path / f'{NAME}.bak').read_text() == text


def test_a_second_broken_file_does_not_push_out_the_first(tmp_path: Path) -> None:
    for text in ('[one', '[two'):
        (tmp_path / NAME).write_text(text)
        ProgressFile(str(tmp_path))
    assert [(tmp_path / f'{NAME}{end}').read_text() for end in ('.bak', '.bak2')] == ['[one', '[two']


def attempts(folder: str, count: int) -> None:
    for _ in range(count):
        with ProgressFile.changing(folder) as file:
            file.of('circle').attempt(1, 12, False)
            file.save()


@pytest.mark.processes
def test_of_saves_at_the_same_time_none_is_lost(tmp_path: Path) -> None:
    context = multiprocessing.get_context('spawn')
    workers = [context.Process(target=attempts, args=(str(tmp_path), 25)) for _ in range(4)]
    for worker in workers:
        worker.start()
    for worker in workers:
        worker.join()
    assert ProgressFile(str(tmp_path)).of('circle').attempts == 100
    assert [path.name for path in tmp_path.iterdir()] == [NAME]
