"""Records attempts in the student's progress file, which determines how specific the advice is. This module also finds hints."""

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

UNCHANGED = 'The file has not changed since your last attempt. Save it first.'
SHORT = 16  # length of a stored digest, in characters


def record_attempt(report: Report, folder: str | None) -> Report:
    """Record an attempt, and return the report with the level of advice that the student has reached.

    :param folder: the directory of the progress file. With None, no attempt is recorded, and the advice has the level KIND.
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
        return replace(report, level=KIND, word=f'Your progress cannot be saved: {error.message}.')
    return replace(report, level=level, is_counted=True, word=file.word or (UNCHANGED if is_same and not passed else ''))


def why_of(report: Report) -> str:
    """Return the sentence in the course's manifest on why an exercise matters on a robot.

    Return '' if a check did not pass, or if the submission does not belong to a course.
    """
    if report.exit_code != ALL_PASSED:
        return ''
    with suppress(UnusableInput):
        return next((item.why for item in read_course(find_course(report.folder)) if item.name == report.rubric), '')
    return ''


def opened(exercise: str, level: int, folder: str | None) -> str:
    """Record that a student has read a hint. Return a message about the progress file, which is usually ''."""
    if folder is None:
        return ''
    try:
        with ProgressFile.changing(folder) as file:
            file.of(exercise).open_hint(level)
            file.save()
    except UnusableInput as error:
        return f'Your progress cannot be saved: {error.message}.'
    return file.word


def progress_folder(file: str) -> str | None:
    """Return the directory of the progress file of the student who works on this file.

    This is the directory ``lessons`` of the course, or the directory of the course. Return None for a file that is not in a
    directory ``exercises`` of a course, such as a solution or a submission.
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
    """Return a hint for the exercise of this submission.

    :param level: 1 for a question, 2 for the place to look at, 3 for almost the answer.
    :raises UnusableInput: if there is no manifest, the manifest does not contain the exercise, or the level does not exist.
    """
    known = read_course(find_course(submission.folder))
    for exercise in known:
        if exercise.name == submission.exercise:
            if not 1 <= level <= len(exercise.hints):
                raise UnusableInput(f'there is no hint of level {level}', help=f'choose a level from 1 to {len(exercise.hints)}')
            variant, hint = variant_for(exercise.name, '', None), exercise.hints[level - 1]
            return f'{exercise.title}, hint {level} of {LEVELS}: {variant.of(hint) if variant else hint}'
    raise UnusableInput(
        f'there is no exercise {submission.exercise}',
        help='choose one of these exercises: ' + ', '.join(exercise.path for exercise in known),
    )
