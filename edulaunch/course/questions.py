"""The questions and explanations of a course.

Authors edit ``solutions/questions.toml``. Students get a file with hidden answers.
"""

from __future__ import annotations

import os
from base64 import b64decode, encodebytes
from typing import Any, NamedTuple

from edugrade.course import here_and_above, parse_toml

from edulaunch.errors import UnusableInput

FILE, SEALED, SOLUTIONS = 'questions.toml', '.questions', 'solutions'
"""The file of authors, in the folder of the solutions. The file of students beside the lessons: its content in Base64.

This keeps answers from being read by accident. It does not protect them: the notebook of a student has to show them later.
"""
LETTERS = 'abcdef'


class Choice(NamedTuple):
    """One choice of a question, and the comment for students who select it."""

    text: str
    feedback: str


class Question(NamedTuple):
    """A question with choices.

    :param name: the name for `quiz`, which is unique in the course.
    :param lesson: the name of the notebook that teaches the answer, without its ending.
    :param right: the letter of the right choice.
    """

    name: str
    lesson: str
    text: str
    choices: tuple[Choice, ...]
    right: str


class Explanation(NamedTuple):
    """A question that students answer in their own words, and the answer with which they compare their explanation.

    :param name: the name for `explain`, which is unique in the course.
    """

    name: str
    lesson: str
    answer: str


class Questions(NamedTuple):
    """The content of a questions file by name, in the order of the file."""

    questions: dict[str, Question]
    explanations: dict[str, Explanation]


def seal(data: bytes) -> bytes:
    """Return the content of a questions file in the form for students."""
    return encodebytes(data)


def questions_file(folder: str) -> str | None:
    """Return the questions file for a folder of lessons, or None if there is no such file. The file of an update takes
    precedence over an older readable file.
    """
    folder = os.path.abspath(folder)
    beside = os.path.join(os.path.dirname(folder), SOLUTIONS, FILE)
    places = (*(os.path.join(folder, name) for name in (SEALED, FILE)), beside)
    return next(filter(os.path.isfile, places), None)


def read_questions(path: str | None) -> Questions:
    """Return the questions and explanations in a file. For None, return no questions.

    :raises UnusableInput: when the file cannot be read or a field is missing. The message names the file and the question.
    """
    if path is None:
        return Questions({}, {})
    try:
        with open(path, 'rb') as file:
            data = file.read()
        tables = parse_toml((b64decode(data, validate=False) if os.path.basename(path) == SEALED else data).decode())
    except (OSError, ValueError) as error:
        raise UnusableInput(f'cannot read the questions in {path}: {error}') from None
    questions = (_question(path, entry) for entry in tables.get('question', []))
    explanations = (_explanation(path, entry) for entry in tables.get('explanation', []))
    return Questions({item.name: item for item in questions}, {item.name: item for item in explanations})


def find_questions() -> Questions:
    """Return the questions beside the notebook, or in the folder ``lessons`` of this folder or a parent folder.

    If there is no such file, return no questions.
    """
    for above in here_and_above(os.curdir):
        for folder in (above, os.path.join(above, 'lessons')):
            if (path := questions_file(folder)) is not None:
                return read_questions(path)
    return read_questions(None)


def _question(path: str, entry: dict[str, Any]) -> Question:
    name = entry.get('name', '?')
    try:
        choices = tuple(Choice(*choice) for choice in entry['choices'])
        question = Question(name, entry['lesson'], entry['text'].strip(), choices, entry['right'])
    except (KeyError, TypeError, AttributeError) as error:
        raise UnusableInput(f'{path}: the question "{name}" lacks {error}', help=_FORM) from None
    if not 2 <= len(choices) <= len(LETTERS) or question.right not in list(LETTERS[: len(choices)]):
        raise UnusableInput(f'{path}: the question "{name}" has no right choice', help=_FORM)
    return question


def _explanation(path: str, entry: dict[str, Any]) -> Explanation:
    name = entry.get('name', '?')
    try:
        return Explanation(name, entry['lesson'], entry['answer'].strip())
    except (KeyError, TypeError, AttributeError) as error:
        help = 'write [[explanation]] with name, lesson and answer'
        raise UnusableInput(f'{path}: the explanation "{name}" lacks {error}', help=help) from None


_FORM = (
    'write [[question]] with name, lesson, text, right = "a", and choices = [["a choice", "the comment on it"], ...],'
    f' two to {len(LETTERS)} of them'
)
