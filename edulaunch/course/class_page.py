"""``edulaunch course class FOLDER``: one page on a class, with each student's progress, difficult exercises and stuck students.

The command reads only the files `my_progress.toml` that students handed in. Students can edit these files, so the page proves
nothing.
"""

from __future__ import annotations

import os
from collections.abc import Iterable, Sequence
from statistics import median
from typing import NamedTuple

from edugrade.course import Exercise, read_course
from edugrade.reports.markup import Markup, element, html_page, joined, table_row

from edulaunch.errors import UnusableInput

from .handed_in import Done, Refused, Standing
from .lessons import LESSONS, manifest
from .questions import Question, questions_file, read_questions

STUCK_TRIES = 4  # number of attempts at an unsolved exercise from which a student counts as stuck
HARDEST = 5
FEW = 2  # successful students added to each count, because a few attempts say little about an exercise
MOST_REFUSED = 50
STYLE = (
    ':root{color-scheme:light dark;--ground:#fff;--ink:#1d2733;--faint:#5b6b7c;--line:#d5dde5;--done:#d7efdc;--tried:#fdeac2;'
    '--stuck:#f8d4d0}'
    '@media(prefers-color-scheme:dark){:root{--ground:#14191f;--ink:#e4e9ee;--faint:#9aa8b6;--line:#34404c;--done:#1f4a2c;'
    '--tried:#57431a;--stuck:#632b27}}'
    'body{font:16px/1.5 system-ui,sans-serif;margin:1.5em auto;max-width:80em;padding:0 1em}'
    'body{background:var(--ground);color:var(--ink)}'
    'h1{margin-bottom:.2em}p,li{max-width:60em}.faint{color:var(--faint)}'
    '.wide{overflow-x:auto}table{border-collapse:collapse}'
    'td,th{text-align:left;vertical-align:top;padding:.25em .7em;border-bottom:1px solid var(--line)}'
    '.grid td,.grid th{padding:.25em .45em;text-align:center;white-space:nowrap}'
    '.grid th[scope=row]{position:sticky;left:0;background:var(--ground);text-align:left}'
    '.grid th[scope=col] span{writing-mode:vertical-rl;transform:rotate(180deg);max-height:10em}'
    '.done{background:var(--done)}.tried{background:var(--tried)}.stuck{background:var(--stuck)}'
)


class Class(NamedTuple):
    """A class and its course."""

    exercises: Sequence[Exercise]
    questions: Sequence[Question]
    standings: Sequence[Standing]
    refused: Sequence[Refused]

    def of(self, student: Standing, exercise: Exercise) -> Done:
        """Return the record of an exercise for one student."""
        return student.exercises.get(exercise.name, Done())


def read_course_of(folder: str) -> tuple[list[Exercise], list[Question]]:
    """Return the exercises and questions of a course.

    :raises UnusableInput: when the course has no exercises, or its files cannot be read.
    """
    place = manifest(folder)
    if place is None:
        raise UnusableInput(f'there is no course in {folder}', help='name one with --course FOLDER')
    path = questions_file(os.path.join(folder, LESSONS))
    return read_course(place), list(read_questions(path).questions.values())


def page_of_class(known: Class) -> str:
    """Return the page on a class as HTML."""
    count = len(known.standings)
    return html_page(
        'A class at a glance',
        STYLE,
        element('h1', 'A class at a glance'),
        element(
            'p',
            f'{count} {"student" if count == 1 else "students"}, {len(known.exercises)} exercises. The page shows the content of '
            'the files my_progress.toml. Students keep these files themselves, so they help you to help, but they prove nothing.',
            class_='faint',
        ),
        *_stuck(known),
        *_hard(known),
        *_questions(known),
        *_grid(known),
        *_refused(known.refused),
    )


def is_stuck(done: Done) -> bool:
    """Return whether a student has tried an exercise many times without solving it."""
    return not done.done and done.attempts >= STUCK_TRIES


def place_of(known: Class, student: Standing) -> str:
    """Return the name of the next exercise of a student, in the order of the course, or 'all done'."""
    places = [number for number, item in enumerate(known.exercises) if known.of(student, item).done]
    after = known.exercises[max(places) + 1 if places else 0 :]
    left = [item for item in (*after, *known.exercises) if not known.of(student, item).done]
    return left[0].name if left else 'all done'


def _stuck(known: Class) -> Iterable[Markup]:
    rows = sorted(
        (-done.attempts, student.student, item, done)
        for student in known.standings
        for item in known.exercises
        if is_stuck(done := known.of(student, item))
    )
    yield element('h2', 'Students who are stuck')
    if not rows:
        yield element('p', f'No student has tried an exercise {STUCK_TRIES} times without success.')
        return
    head = table_row('student', 'exercise', 'tries', 'hints', 'best points', kind='th')
    cells = [
        table_row(student, item.title, str(done.attempts), str(done.hints), f'{done.best_points:g} of {item.points}')
        for _, student, item, done in rows
    ]
    yield element('div', element('table', head, *cells), class_='wide')


def _hard(known: Class) -> Iterable[Markup]:
    found = []
    for item in known.exercises:
        tried = [done for student in known.standings if (done := known.of(student, item)).attempts]
        if tried:
            undone = sum(not done.done for done in tried)
            found.append((undone / (len(tried) + FEW), median(done.attempts for done in tried), item, tried, undone))
    found.sort(key=lambda row: (-row[0], -row[1]))
    yield element('h2', 'Difficult exercises')
    if not found:
        yield element('p', 'No student has tried an exercise yet.')
        return
    head = table_row('exercise', 'lesson', 'tried', 'not done', 'tries (median)', 'opened a hint', kind='th')
    rows = [
        table_row(item.title, item.lesson, str(len(tried)), str(undone), f'{tries:g}', str(sum(done.hints > 0 for done in tried)))
        for _, tries, item, tried, undone in found[:HARDEST]
    ]
    yield element('div', element('table', head, *rows), class_='wide')


def _questions(known: Class) -> Iterable[Markup]:
    found = []
    for question in known.questions:
        first = [student.answers[question.name][0] for student in known.standings if student.answers.get(question.name)]
        wrong = [letter for letter in first if letter != question.right]
        if wrong:
            usual = max(sorted(set(wrong)), key=wrong.count)
            place = 'abcdef'.find(usual)
            text = question.choices[place].text if 0 <= place < len(question.choices) else ''
            found.append((-len(wrong) / len(first), question.text, f'{len(wrong)} of {len(first)}', f'{usual}) {text}'))
    if not found:
        return
    found.sort()
    yield element('h2', 'Questions with a wrong first answer')
    head = table_row('question', 'wrong at first', 'most frequent wrong answer', kind='th')
    yield element('div', element('table', head, *(table_row(*row[1:]) for row in found[:HARDEST])), class_='wide')


def _grid(known: Class) -> Iterable[Markup]:
    yield element('h2', 'Progress of each student')
    yield element(
        'p',
        '✓ means done, followed by the number of attempts. A number alone counts the attempts at an exercise that is not '
        f'done. It has an exclamation mark from {STUCK_TRIES} attempts.',
        class_='faint',
    )
    columns = (
        element('th', element('span', item.name), scope='col', title=f'{item.title} ({item.lesson})') for item in known.exercises
    )
    head = element('tr', element('th', 'student'), element('th', 'next'), element('th', 'done'), *columns)
    rows = [
        element(
            'tr',
            element('th', student.student, scope='row'),
            element('td', place_of(known, student)),
            element('td', str(sum(known.of(student, item).done for item in known.exercises))),
            *(_cell(known.of(student, item)) for item in known.exercises),
        )
        for student in known.standings
    ]
    yield element('div', element('table', head, *rows, class_='grid'), class_='wide')


def _cell(done: Done) -> Markup:
    if not done.attempts and not done.done:
        return element('td')
    text = f'✓{done.attempts}' if done.done else f'{done.attempts}{"!" if is_stuck(done) else ""}'
    return element('td', text, class_='done' if done.done else 'stuck' if is_stuck(done) else 'tried')


def _refused(refused: Sequence[Refused]) -> Iterable[Markup]:
    if refused:
        yield element('h2', 'Files that could not be read')
        yield element('ul', *(element('li', joined(f'{item.path}: {item.why}')) for item in refused[:MOST_REFUSED]))
