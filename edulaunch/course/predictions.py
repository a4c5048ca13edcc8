"""A prediction is entered before the run, kept in the progress file of the current folder, and compared with what happened."""

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
"""Characters of a prediction that are kept."""


BOX = 'border-left:4px solid #888;padding:.1em 1em;max-width:60em'
"""The style of what a lesson's questions show."""


class Verdict:
    """A few sentences, as text and as HTML."""

    def __init__(self, *lines: str) -> None:
        self.lines = [line for line in lines if line]

    def __repr__(self) -> str:
        return '\n'.join(self.lines)

    def _repr_html_(self) -> str:
        return element('div', joined(*(element('p', line, style='margin:.3em 0') for line in self.lines)), style=BOX)


def predict(name: str, guess: Any) -> Verdict:
    """Keep what you expect, before you look.

    :param name: what the prediction is about; `compare` asks for it under this name.
    :param guess: a number, several numbers in parentheses, a word. ``...``, as a lesson hands it out, is no guess yet.
    """
    if isinstance(guess, EllipsisType):
        return Verdict('No prediction yet: replace the three dots by what you expect, and run this cell again.')
    guessed = visible(_text(guess))[:LONGEST]
    return Verdict(f'Kept: {guessed}. Now run the next cell.', keep(lambda file: file.predictions.update({name: guessed})))


def compare(name: str, was: Any) -> Verdict:
    """Put what happened beside what was predicted under this name.

    Two numbers, or points of equally many, are compared by their distance.

    :param was: what happened: a number, several numbers, a word.
    """
    guessed = kept().predictions.get(name)
    if guessed is None:
        return Verdict(f'It was {_text(was)}. You had no prediction: guess first next time, it helps you to remember.')
    return Verdict(f'You predicted {guessed}, it was {_text(was)}{_verdict(guessed, _text(was))}')


def _text(value: Any) -> str:
    """A value as a person writes it: numbers short, words without quotes."""
    if isinstance(value, str):
        return value.strip()
    if isinstance(value, float):
        return f'{value:.4g}'
    if isinstance(value, list | tuple):
        return f'({", ".join(map(_text, value))})'
    item = getattr(value, 'item', None)  # a number of numpy's
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
    """Words without what does not matter in them: "No." is "no"."""
    return ' '.join(text.casefold().strip(' .!?').replace(',', ' ').split())


def _numbers(text: str) -> list[float] | None:
    """The numbers of a text that is nothing but numbers, with or without parentheses."""
    try:
        return [float(word) for word in text.strip('()[] ').split(',')]
    except ValueError:
        return None


def keep(change: Callable[[ProgressFile], None]) -> str:
    """Change the progress file. Returns what the student must be told about it, mostly nothing.

    A file that cannot be written costs nobody an answer.
    """
    try:
        with ProgressFile.changing(os.getcwd()) as file:
            change(file)
            file.save()
    except UnusableInput as error:
        return f'Your answer is not kept: {error.message}.'
    return file.word


def kept() -> ProgressFile:
    """The progress of the current folder."""
    return ProgressFile(os.getcwd())
