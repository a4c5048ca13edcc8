"""``quiz('name', ...)``: a question with choices. Write a letter in place of the dots to answer it.

The output is text and plain HTML without scripts or widgets. A saved notebook thus still shows the question, the answer and
the comment.
"""

from __future__ import annotations

from types import EllipsisType

from edugrade.reports.markup import element, joined

from edulaunch.engine.nearest import nearest
from edulaunch.errors import UnusableInput

from .predictions import BOX, Verdict, keep
from .questions import FILE, LETTERS, Question, find_questions


def find_question(name: str) -> Question:
    """Return the question with this name.

    :raises UnusableInput: for an unknown name; the message contains the most similar name.
    """
    known = find_questions().questions
    if name in known:
        return known[name]
    near = nearest(name, known)
    there = (
        f'did you mean quiz({near!r}, ...)?' if near else f'There are: {", ".join(known) or f"none, because {FILE} is missing"}'
    )
    raise UnusableInput(f'there is no question "{name}"', help=there)


_CHOICE = 'margin:.2em 0 .2em 1.5em'
"""The style of a choice. Its letter is part of the text, because JupyterLab replaces letters in a list by its own numbers."""


class Asked:
    """A question in the form that a cell shows, before or after the answer.

    :param chosen: the letter of the answer; empty before the answer.
    :param word: a message about the progress file, usually empty.
    """

    def __init__(self, question: Question, chosen: str = '', word: str = '') -> None:
        self.question = question
        self.chosen = chosen
        self._word = word

    @property
    def comment(self) -> list[str]:
        """Return the lines below the choices."""
        question = self.question
        if not self.chosen:
            return [
                f"To answer, replace the three dots: quiz({question.name!r}, 'a'), or another letter. Then run the cell again."
            ]
        verdict = 'Right.' if self.chosen == question.right else 'Not quite.'
        return [f'{verdict} {question.choices[LETTERS.index(self.chosen)].feedback}', *([self._word] if self._word else [])]

    def __repr__(self) -> str:
        choices = zip(LETTERS, self.question.choices, strict=False)
        lines = [f'{"*" if letter == self.chosen else " "} {letter}) {choice.text}' for letter, choice in choices]
        return '\n'.join([self.question.text, *lines, *self.comment])

    def _repr_html_(self) -> str:
        choices = zip(LETTERS, self.question.choices, strict=False)
        items = (
            element('p', element('b', f'{letter}) {choice.text} (your answer)'), style=_CHOICE)
            if letter == self.chosen
            else element('p', f'{letter}) {choice.text}', style=_CHOICE)
            for letter, choice in choices
        )
        return element(
            'div',
            element('p', element('b', self.question.text)),
            joined(*items),
            joined(*(element('p', line) for line in self.comment)),
            style=BOX,
        )


def quiz(name: str, choice: str | EllipsisType = ...) -> Asked | Verdict:
    """Show a question of the course, or answer it. Each answer is stored in the progress file.

    :param name: the name of the question in `questions.toml`.
    :param choice: the letter of an answer. The placeholder ``...`` of the lesson shows the question.
    :raises UnusableInput: for an unknown question; the message contains the most similar name.
    """
    try:
        question = find_question(name)
    except UnusableInput as error:
        return Verdict(str(error))
    if isinstance(choice, EllipsisType):
        return Asked(question)
    letter = str(choice).strip().strip(')').lower()
    letters = LETTERS[: len(question.choices)]
    if len(letter) != 1 or letter not in letters:
        return Verdict(f'{choice!r} is not one of the choices: {", ".join(letters)}.')
    return Asked(question, letter, keep(lambda file: file.answers.setdefault(question.name, []).append(letter)))
