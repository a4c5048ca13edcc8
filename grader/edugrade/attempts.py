"""What a student tried is noted in the student's own file; from there comes how much a report gives away. And the hints."""

from __future__ import annotations

import os
from contextlib import suppress
from dataclasses import replace

from edulaunch.errors import UnusableInput

from .course import LEVELS, MANIFEST, find_course, here_and_above, read_course
from .progress_file import NAME, ProgressFile
from .reports.wording import KIND, level_of
from .results import ALL_PASSED, Report
from .submission import Submission
from .variant import variant_for

UNCHANGED = 'unchanged since your last try: did you save?'
SHORT = 16  # signs of a digest


def record_attempt(report: Report, folder: str | None) -> Report:
    """The report, told as far as the student has come.

    :param folder: of the progress file; None: nothing is kept, and only the kind of what is missing is told.
    """
    report = replace(report, why=why_of(report))
    if folder is None or report.earned is None:
        return replace(report, level=KIND)
    passed = report.exit_code == ALL_PASSED
    try:
        with ProgressFile.changing(folder) as file:
            mine, text = file.of(report.rubric), report.sha256[:SHORT]
            is_same = mine.attempt(report.earned, report.possible, passed, text)
            level = level_of(mine.attempts, mine.hints, mine.first == text)
            file.save()
    except UnusableInput as error:
        return replace(report, level=KIND, word=f'Your progress is not kept: {error.message}.')
    return replace(report, level=level, word=file.word or (UNCHANGED if is_same and not passed else ''))


def why_of(report: Report) -> str:
    """Why an exercise that is done matters on a robot, by the course's manifest; '' for one that is not done or of no course."""
    if report.exit_code != ALL_PASSED:
        return ''
    with suppress(UnusableInput):
        return next((item.why for item in read_course(find_course(report.folder)) if item.name == report.rubric), '')
    return ''


def opened(exercise: str, level: int, folder: str | None) -> str:
    """Note that a hint was read. Returns what the student must be told about the file; mostly nothing."""
    if folder is None:
        return ''
    try:
        with ProgressFile.changing(folder) as file:
            file.of(exercise).open_hint(level)
            file.save()
    except UnusableInput as error:
        return f'Your progress is not kept: {error.message}.'
    return file.word


def progress_folder(file: str) -> str | None:
    """Where the progress of a student is kept who works on this file: in the course's folder ``lessons``, else in the course's.

    None for what does not lie in a course's folder ``exercises``: a solution, a submission, a file of its own.
    """
    for folder in here_and_above(os.path.dirname(file)):
        inside, above = os.path.basename(folder) == 'exercises', os.path.dirname(folder)
        if inside and any(os.path.isfile(os.path.join(place, MANIFEST)) for place in (folder, above)):
            lessons = os.path.join(above, 'lessons')
            if os.path.isdir(lessons) and not os.path.isfile(os.path.join(above, NAME)):
                return lessons
            return above
    return None


def find_hint(submission: Submission, level: int) -> str:
    """A hint for the exercise that this submission belongs to.

    :param level: 1 asks a question, 2 says where to look, 3 is almost the answer.
    :raises UnusableInput: when there is no manifest, no such exercise in it, or no such level.
    """
    known = read_course(find_course(submission.folder))
    for exercise in known:
        if exercise.name == submission.exercise:
            if not 1 <= level <= len(exercise.hints):
                raise UnusableInput(f'there is no hint of level {level}', help=f'levels are 1 to {len(exercise.hints)}')
            variant, hint = variant_for(exercise.name, '', None), exercise.hints[level - 1]
            return f'{exercise.title}, hint {level} of {LEVELS}: {variant.of(hint) if variant else hint}'
    raise UnusableInput(
        f'there is no exercise {submission.exercise}', help='exercises: ' + ', '.join(exercise.path for exercise in known)
    )
