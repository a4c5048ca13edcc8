"""``quiz('name')``: a question of the course's ``questions.toml``, with buttons where there are widgets, as text everywhere."""

from __future__ import annotations

import os
from collections.abc import Callable
from html import escape
from typing import Any, NamedTuple

from edugrade.course import here_and_above, read_toml

from edulaunch.engine.nearest import nearest
from edulaunch.errors import UnusableInput

from .predictions import Words, keep

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
    for above in here_and_above(os.curdir):
        for path in (os.path.join(above, FILE), os.path.join(above, 'lessons', FILE)):
            if os.path.isfile(path):
                return read_questions(path)
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


class Asked:
    """A question as it stands in a cell: text, and buttons where the front end has widgets."""

    def __init__(self, question: Question) -> None:
        self.question = question

    def __repr__(self) -> str:
        question = self.question
        lines = [f'  {letter}) {choice.text}' for letter, choice in zip(LETTERS, question.choices, strict=False)]
        return '\n'.join([question.text, *lines, f'Answer with quiz({question.name!r}, {LETTERS[0]!r}), or another letter.'])

    def _repr_mimebundle_(self, include: Any = None, exclude: Any = None) -> Any:
        text = {'text/plain': repr(self)}
        try:
            bundle = quiz_widget(self.question, lambda letter: answer(self.question, letter))
        except ImportError:  # no ipywidgets: the text is the question
            return text
        return {**bundle, **text}


def quiz(name: str, choice: str | None = None) -> Asked | Words:
    """Ask a question of the course, or answer it.

    :param choice: the letter of an answer; without it the question is shown.
    """
    try:
        question = find_question(name)
    except UnusableInput as error:
        return Words(str(error))
    return Asked(question) if choice is None else answer(question, str(choice))


def answer(question: Question, choice: str) -> Words:
    """What somebody is told who chose this letter; the choice is kept."""
    letter = choice.strip().strip(')').lower()
    letters = LETTERS[: len(question.choices)]
    if len(letter) != 1 or letter not in letters:
        return Words(f'{choice!r} is none of the choices: {", ".join(letters)}.')
    word = keep(lambda file: file.answers.setdefault(question.name, []).append(letter))
    verdict = 'Right.' if letter == question.right else 'Not quite.'
    return Words(f'{verdict} {question.choices[letters.index(letter)].feedback}', word)


def quiz_widget(question: Question, answer: Callable[[str], Words]) -> dict[str, Any]:
    """The mime bundle of the question, its choices, and a button for each; a click shows what is told below.

    :param answer: called with the letter that was chosen.
    :raises ImportError: without ipywidgets.
    """
    import ipywidgets

    choices = ''.join(f'<li>{escape(choice.text)}</li>' for choice in question.choices)
    text = f'<p><b>{escape(question.text)}</b></p><ol type="a" style="line-height:1.5">{choices}</ol>'
    told = ipywidgets.HTML()

    def clicked(button: Any) -> None:
        told.value = f'<p aria-live="polite"><b>{button.description})</b> {escape(repr(answer(button.description)))}</p>'

    layout = ipywidgets.Layout(width='3em')
    row = [
        ipywidgets.Button(description=letter, tooltip=choice.text, layout=layout)
        for letter, choice in zip(LETTERS, question.choices, strict=False)
    ]
    for button in row:
        button.on_click(clicked)
    bundle: dict[str, Any] = ipywidgets.VBox([ipywidgets.HTML(text), ipywidgets.HBox(row), told])._repr_mimebundle_()
    return bundle
