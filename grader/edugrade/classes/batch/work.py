"""Grades the submissions of a class that need it, and stores each result immediately."""

from __future__ import annotations

import argparse
import os
import sys
from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import NamedTuple

from edulaunch.errors import UnusableInput

from ...faults import ComputerFault, words_of
from ...files import write_whole
from ...grading import Work, grade, plan_work, progress_bar
from ...job import Limits
from ...options import is_personal
from ...reports.document import document, receipt
from ...results import BROKEN_GRADER, UNUSABLE_INPUT, VERDICTS, Report
from ...rubric import NoSuchCheck
from ...submission import Submission
from ...variant import CourseSecret
from .entries import Entry
from .store import Result, Store, merged


class Options(NamedTuple):
    """The options for grading a class; see the help of the command."""

    rubric: str | None = None
    seed: int | None = None
    secret: CourseSecret | None = None
    only: str | None = None
    resume: bool = False
    limits: Limits = Limits()
    workspaces: Sequence[str] = ()
    jobs: int | None = None
    html: str | None = None
    is_personal: bool = False
    replays: bool = False

    @classmethod
    def of(cls, words: argparse.Namespace) -> Options:
        """Return the options for the parsed arguments of a command line."""
        secret = CourseSecret(words.course_secret_file) if words.course_secret_file else None
        limits = Limits(words.limit, sandbox=words.sandbox)
        common = (words.rubric, words.seed, secret, words.only, words.resume, limits, words.workspace, words.jobs, words.html)
        return cls(*common, is_personal(words), words.replays)


def plan(entry: Entry, options: Options) -> Work:
    """Return the work for a submission: rubric, seed and scenarios.

    :raises UnusableInput: when the submission cannot be graded, with the reason.
    """
    if entry.refused:
        raise UnusableInput(entry.refused, help=entry.help)
    student = entry.id or entry.student
    called = entry.student if options.is_personal else ''
    return plan_work(
        Submission(entry.file, entry.root), options.rubric, options.seed, options.secret, student, options.only, called=called
    )


def work_to_do(entries: Sequence[Entry], store: Store, options: Options) -> Iterator[tuple[Entry, Work]]:
    """Yield the submissions to grade. If a submission cannot be graded, store a result with the reason instead.

    With the option `resume`, submissions with a current result are left out. With a single check, submissions of exercises
    without this check are left out, and their results do not change.

    :raises UnusableInput: when no exercise has the check.
    """
    strange, known = None, 0
    for entry in entries:
        try:
            work = plan(entry, options)
            known += 1
            if not (options.resume and is_current(store, entry, work, options)):
                yield entry, work
        except NoSuchCheck as error:
            strange = error
        except UnusableInput as error:
            keep(store, entry, refusal(UNUSABLE_INPUT, error.message, error.help))
        except Exception as error:  # the grader failed at this submission
            keep(store, entry, refusal(BROKEN_GRADER, *words_of(error)))
    if strange is not None and not known:
        raise strange


def is_current(store: Store, entry: Entry, work: Work, options: Options) -> bool:
    """Return whether there is a result for this submission, rubric, engine and seed, with a page if the user wants pages."""
    found = store.result(entry)
    if found is None or found.get('receipt') != receipt(work) or found.get('exit_code') == BROKEN_GRADER:
        return False
    return not options.html or os.path.exists(store.path(entry, '.html', options.html))


def refusal(exit_code: int, reason: str, help: str | None = None) -> Result:
    """Return the result of a submission that could not be graded. It has no mark, which is different from zero points."""
    return {'exit_code': exit_code, 'verdict': VERDICTS[exit_code], 'refused': reason, 'help': help}


def keep(store: Store, entry: Entry, result: Result) -> bool:
    """Write a result, and return whether this succeeded. A failure prints a message and affects only this result."""
    try:
        store.save(entry, result)
    except (ComputerFault, UnusableInput) as error:
        print(f'edugrade: the result of {entry.student} cannot be saved: {error}', file=sys.stderr)
        store.unkept.add(entry.path)
        return False
    return True


def grade_here(todo: Sequence[tuple[Entry, Work]], store: Store, options: Options) -> None:
    """Grade on this machine, with `jobs` parallel runs."""
    works = [work for _, work in todo]
    with progress_bar(sum(len(work.scenarios) for work in works)) as advance:
        reports = grade(works, options.limits, options.workspaces, advance, options.jobs, for_documents=True)
        for (entry, _), report in zip(todo, reports, strict=True):
            keep_report(store, entry, replace(report, student=entry.student), options)


def keep_report(store: Store, entry: Entry, report: Report, options: Options) -> None:
    """Write the page of a submission if the user wants pages, and then the result."""
    try:
        if options.html and not options.only:
            from ...reports.page import page

            keep_page(store.path(entry, '.html', options.html), page([report], [], is_small=not options.replays))
        found = document(report)
    except Exception as error:  # a fault of the grader with one submission must not affect the others
        found = refusal(BROKEN_GRADER, *words_of(error))
    store.record_duration(entry, sum(outcome.real_s for outcome in report.outcomes))
    keep_document(store, entry, found, options)


def keep_page(path: str, text: str) -> None:
    """Write a page. A failure prints a message, and does not change the mark."""
    try:
        os.makedirs(os.path.dirname(path), exist_ok=True)
        write_whole(path, text)
    except (OSError, UnusableInput) as error:
        print(f'edugrade: {error}', file=sys.stderr)


def keep_document(store: Store, entry: Entry, found: Result, options: Options) -> None:
    """Write the result of a submission. A single check that was graded again is merged into the existing result."""
    earlier = store.result(entry) if options.only else None
    if options.only and earlier and 'checks' in earlier and 'checks' in found:
        found = merged(earlier, found, options.only)
    keep(store, entry, found)
