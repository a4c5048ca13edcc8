"""The questions of a course, read from ``questions.toml`` in its folder of lessons."""

from __future__ import annotations

import os
from typing import Any, NamedTuple

from edugrade.course import HIGHEST, read_toml

from edulaunch.errors import UnusableInput
from edulaunch.nearest import nearest

FILE = 'questions.toml'
LETTERS = 'abcdef'


class Choice(NamedTuple):
    """One of the answers, and what somebody who chose it is told."""

    text: str
    feedback: str


class Question(NamedTuple):
    """A question with choices.

    :param name: it is asked by, unique in the course.
    :param lesson: the notebook, without its ending, that teaches it.
    :param right: the letter of the right choice.
    """

    name: str
    lesson: str
    text: str
    choices: tuple[Choice, ...]
    right: str


def read_questions(path: str) -> dict[str, Question]:
    """The questions of a file, by name, in its order.

    :raises UnusableInput: when the file cannot be read, or a question lacks something; file and question are named.
    """
    try:
        entries = read_toml(path).get('question', [])
    except (OSError, ValueError) as error:
        raise UnusableInput(f'the questions in {path} cannot be read: {error}') from None
    return {question.name: question for question in (_question(path, entry) for entry in entries)}


def find_questions() -> dict[str, Question]:
    """The questions beside the notebook, or in the folder ``lessons`` here or above; none when there is no such file."""
    above = os.getcwd()
    for _ in range(HIGHEST):
        for folder in (above, os.path.join(above, 'lessons')):
            if os.path.isfile(path := os.path.join(folder, FILE)):
                return read_questions(path)
        above = os.path.dirname(above)
    return {}


def find_question(name: str) -> Question:
    """A question by its name.

    :raises UnusableInput: when there is none; names the nearest.
    """
    known = find_questions()
    if name in known:
        return known[name]
    near = nearest(name, known)
    there = f'did you mean quiz({near!r})?' if near else f'There are: {", ".join(known) or f"none, for there is no {FILE} here"}'
    raise UnusableInput(f'there is no question "{name}"', help=there)


def _question(path: str, entry: dict[str, Any]) -> Question:
    name = entry.get('name', '?')
    try:
        choices = tuple(Choice(*choice) for choice in entry['choices'])
        question = Question(name, entry['lesson'], entry['text'].strip(), choices, entry['right'])
    except (KeyError, TypeError, AttributeError) as error:
        raise UnusableInput(f'{path}: the question "{name}" lacks {error}', help=_FORM) from None
    if not 2 <= len(choices) <= len(LETTERS) or question.right not in LETTERS[: len(choices)] or len(question.right) != 1:
        raise UnusableInput(f'{path}: the question "{name}" has no right choice', help=_FORM)
    return question


_FORM = (
    '[[question]] with name, lesson, text, right = "a", and choices = [["an answer", "what is told to who chose it"], ...],'
    f' two to {len(LETTERS)} of them'
)
