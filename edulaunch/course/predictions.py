"""Predictions, which students enter before a run and compare with the result. Predictions are stored in the progress file of
the folder.
"""

from __future__ import annotations

import math
import os
from collections.abc import Callable
from types import EllipsisType
from typing import Any

from edugrade.progress_file import ProgressFile
from edugrade.reports.markup import element, joined, visible

from edulaunch.errors import UnusableInput

LONGEST = 300
"""The maximum number of characters of a stored prediction."""


BOX = 'border-left:4px solid #888;padding:.1em 1em;max-width:60em'
"""The style of questions and answers in a lesson."""


class Verdict:
    """A message of a few sentences, as text and as HTML."""

    def __init__(self, *lines: str) -> None:
        self.lines = [line for line in lines if line]

    def __repr__(self) -> str:
        return '\n'.join(self.lines)

    def _repr_html_(self) -> str:
        return element('div', joined(*(element('p', line, style='margin:.3em 0') for line in self.lines)), style=BOX)


def predict(name: str, guess: Any) -> Verdict:
    """Store your expectation before you see the result.

    :param name: the name of the prediction; `compare` uses the same name.
    :param guess: a number, several numbers in parentheses, or a word. The placeholder ``...`` of the lesson is not a prediction.
    """
    if isinstance(guess, EllipsisType):
        return Verdict('No prediction yet: replace the three dots with your prediction, and run this cell again.')
    guessed = visible(_text(guess))[:LONGEST]
    return Verdict(f'Stored: {guessed}. Now run the next cell.', keep(lambda file: file.predictions.update({name: guessed})))


def compare(name: str, was: Any) -> Verdict:
    """Show the result beside the prediction with this name.

    Two numbers, or points of the same dimension, are compared by their distance.

    :param name: the name of the prediction.
    :param was: the result: a number, several numbers, or a word.
    """
    guessed = kept().predictions.get(name)
    if guessed is None:
        return Verdict(f'The result is {_text(was)}. You made no prediction. Predict first next time: it helps you to remember.')
    return Verdict(f'You predicted {guessed}, the result is {_text(was)}{_verdict(guessed, _text(was))}')


def _text(value: Any) -> str:
    """Return a value in readable form: short numbers, words without quotation marks."""
    if isinstance(value, str):
        return value.strip()
    if isinstance(value, float):
        return f'{value:.4g}'
    if isinstance(value, list | tuple):
        return f'({", ".join(map(_text, value))})'
    item = getattr(value, 'item', None)  # numbers of numpy have this method
    return _text(item()) if item is not None else str(value)


def _verdict(guessed: str, was: str) -> str:
    ours, theirs = _numbers(guessed), _numbers(was)
    if ours is None or theirs is None:
        return ': right.' if _bare(guessed) == _bare(was) else '.'
    if len(ours) != len(theirs):
        return f': write {len(theirs)} numbers.' if len(theirs) > 1 else ': write one number.'
    off = math.dist(ours, theirs)
    return ': exactly.' if off == 0 else f': {_text(off)} off.'


def _bare(text: str) -> str:
    """Return a string without unimportant differences, so that "No." becomes "no"."""
    return ' '.join(text.casefold().strip(' .!?').replace(',', ' ').split())


def _numbers(text: str) -> list[float] | None:
    """Return the numbers of a string that contains only numbers, with or without parentheses."""
    try:
        return [float(word) for word in text.strip('()[] ').split(',')]
    except ValueError:
        return None


def keep(change: Callable[[ProgressFile], None]) -> str:
    """Change the progress file. Return a message for the student, usually an empty string.

    If the file cannot be written, the answer stays in the notebook.
    """
    try:
        with ProgressFile.changing(os.getcwd()) as file:
            change(file)
            file.save()
    except UnusableInput as error:
        return f'Your answer is not kept: {error.message}.'
    return file.word


def kept() -> ProgressFile:
    """Return the progress of the current folder."""
    return ProgressFile(os.getcwd())
