"""``quiz('name')``: a question with choices, as buttons where there are widgets, as text everywhere."""

from __future__ import annotations

from typing import Any

from edulaunch.errors import UnusableInput

from .kept import keep
from .predictions import Words
from .questions import LETTERS, Question, find_question


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
            from .quiz_widget import quiz_widget
        except ImportError:  # no ipywidgets: the text is the question
            return text
        bundle = quiz_widget(self.question, lambda letter: answer(self.question, letter))
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
