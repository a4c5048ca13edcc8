"""``edugrade batch SUBMISSIONS/``: grades a class, one result file for each submission, and goes on where it was stopped."""

from __future__ import annotations

import argparse
import json
import os
from collections.abc import Iterator, Sequence
from contextlib import suppress
from hashlib import sha256
from typing import Any, NamedTuple

from edulaunch.errors import UnusableInput

from .catalogue import exercises, find_rubric, rubric_file
from .document import document, json_text
from .grading import Work, grade
from .limits import Limits
from .package_folder import package_at
from .regular_file import read_regular
from .results import Report
from .submission import ENDINGS, Submission, exercise_of
from .whole_file import write_whole

DEEPEST = 8  # folders below the one that is given
LARGEST_RESULT = 10_000_000


class Entry(NamedTuple):
    """A submission of a class: its path relative to the folder of all, and the first part of it, which names the student."""

    path: str
    student: str


class Class:
    """The submissions in a folder, and their results in another one.

    :param folder: has a folder or a launch file for each student.
    :param out: where the results go: for each submission ``<its path>.json``.
    :param rubric: the only exercise to be graded, by name or file; default: all that have a rubric.
    :param seed: see `edugrade --seed`; the same for all.
    """

    def __init__(self, folder: str, out: str, rubric: str | None = None, seed: int | None = None) -> None:
        if not os.path.isdir(folder):
            raise UnusableInput(f'{folder} is not a folder', help='give the folder that has a folder or file for each student')
        self.folder = folder
        self.out = out
        self._rubric = rubric
        self._seed = seed
        self._wanted = [find_rubric('', rubric)[0]] if rubric else exercises()
        self.entries = list(self._find())

    def result_path(self, entry: Entry) -> str:
        """Where the result of a submission is, or will be."""
        return os.path.join(self.out, f'{entry.path}.json')

    def result(self, entry: Entry) -> dict[str, Any] | None:
        """The result that is there; None without one, or with half of one from somebody else's hand."""
        with suppress(OSError, ValueError):
            found = json.loads(read_regular(self.result_path(entry), LARGEST_RESULT))
            if isinstance(found, dict) and 'student' in found:
                return found
        return None

    def is_current(self, entry: Entry, work: Work) -> bool:
        """Whether the result is there already: of this text, by this rubric, engine and seed."""
        found = self.result(entry)
        return found is not None and found.get('made_from') == made_from(work, self._rubric) and found.get('exit_code') != 3

    def plan(self, entry: Entry) -> Work:
        """What a submission is graded by. Raises UnusableInput when it cannot be graded."""
        submission = Submission(os.path.join(self.folder, entry.path))
        name, rubric = find_rubric(submission.exercise, self._rubric)
        return Work(submission, name, rubric, submission.seed if self._seed is None else self._seed)

    def save(self, entry: Entry, work: Work | None, content: dict[str, Any]) -> None:
        """Write one result, whole or not at all."""
        path = self.result_path(entry)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        origin = None if work is None else made_from(work, self._rubric)
        write_whole(path, json_text({'student': entry.student, 'path': entry.path, 'made_from': origin, **content}))

    def _find(self) -> Iterator[Entry]:
        """All submissions, in alphabetical order. Links are not followed."""
        pending = [('', 0)]
        while pending:
            inside, depth = pending.pop()
            folder = os.path.join(self.folder, inside)
            package = package_at(folder) if inside else None
            if package is not None:
                if package.name in self._wanted:
                    yield _entry(inside)
                continue
            with suppress(OSError), os.scandir(folder) as found:
                entries = sorted((item for item in found if not item.is_symlink()), key=lambda item: item.name)
                for item in entries:
                    if item.name.endswith(ENDINGS) and not item.is_dir() and self._is_wanted(item.name):
                        yield _entry(os.path.join(inside, item.name))
                below = [item for item in entries if item.is_dir() and depth < DEEPEST and not item.name.startswith('.')]
                pending += [(os.path.join(inside, item.name), depth + 1) for item in reversed(below)]

    def _is_wanted(self, name: str) -> bool:
        return self._rubric is not None or exercise_of(name) in self._wanted


def made_from(work: Work, rubric: str | None) -> dict[str, Any]:
    """What a result depends on: with the same it would be the same."""
    from edulaunch.version import __version__

    rule = sha256(read_regular(rubric_file(work.submission.exercise, rubric), LARGEST_RESULT)).hexdigest()
    return {'submission': work.submission.sha256, 'rubric': rule, 'edulaunch': __version__, 'seed': work.seed}


def _entry(path: str) -> Entry:
    first, _, rest = path.partition(os.sep)
    return Entry(path, first if rest else exercise_of(first))


def run(group: Class, options: argparse.Namespace) -> int:
    """Grade what has to be graded, one result at a time. Returns the exit code."""
    todo: list[tuple[Entry, Work]] = []
    kept = 0
    for entry in group.entries:
        try:
            work = group.plan(entry)
            if options.resume and group.is_current(entry, work):
                kept += 1
            else:
                todo.append((entry, work))
        except UnusableInput as error:
            group.save(entry, None, {'exit_code': 2, 'refused': error.message, 'help': error.help})
        except Exception as error:  # a fault of ours with one of them
            group.save(entry, None, {'exit_code': 3, 'refused': f'the grader broke on it: {type(error).__name__}: {error}'})
    from .progress_bar import progress_bar

    limits = Limits(options.limit, sandbox=options.sandbox)
    works = [work for _, work in todo]
    with progress_bar(sum(len(work.rubric.scenarios(work.seed)) for work in works)) as advance:
        reports = grade(works, limits, options.workspace, advance, options.jobs)
        for (entry, work), report in zip(todo, reports, strict=True):
            group.save(entry, work, document(report))
            if options.html is not None:
                _write_page(os.path.join(options.html, f'{entry.path}.html'), report)
    results = [(entry, group.result(entry)) for entry in group.entries]
    _write_tables(results, options)
    print(_closing(group, kept, results))
    return max([(found or {}).get('exit_code', 3) == 3 for _, found in results], default=False) * 3


def _write_page(path: str, report: Report) -> None:
    from .page import page

    os.makedirs(os.path.dirname(path), exist_ok=True)
    write_whole(path, page([report], []))


def _write_tables(results: Sequence[tuple[Entry, dict[str, Any] | None]], options: argparse.Namespace) -> None:
    from .class_tables import class_csv, class_page

    if options.csv is not None:
        write_whole(options.csv, class_csv(results))
    if options.html is not None:
        os.makedirs(options.html, exist_ok=True)
        write_whole(os.path.join(options.html, 'index.html'), class_page(results))


def _closing(group: Class, kept: int, results: Sequence[tuple[Entry, dict[str, Any] | None]]) -> str:
    marked = sum(1 for _, found in results if found and found.get('points', {}).get('earned') is not None)
    before = f', {kept} of them from before' if kept else ''
    return f'{len(results)} submissions{before}; {marked} have a mark. Results: {group.out}'


def main(words: Sequence[str]) -> int:
    """The command behind ``edugrade batch``."""
    from .options import read_batch_options

    options = read_batch_options(words)
    out = options.out or options.folder.rstrip(os.sep) + '.results'
    return run(Class(options.folder, out, options.rubric, options.seed), options)
