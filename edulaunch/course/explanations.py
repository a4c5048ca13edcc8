"""``explain('name', ...)``: students first write an explanation in their own words, and then read the answer beside it."""

from __future__ import annotations

from types import EllipsisType

from edugrade.reports.markup import visible

from edulaunch.engine.nearest import nearest

from .predictions import Verdict, keep
from .questions import FILE, find_questions

LONGEST = 2000
"""The maximum number of characters of a stored explanation."""
FEWEST = 4
"""The minimum number of words of an explanation. A shorter one does not open the answer."""


def explain(name: str, text: str | EllipsisType = ...) -> Verdict:
    """Store an explanation in the progress file, and show the answer.

    :param name: the name of the explanation in `questions.toml`.
    :param text: one or two sentences. The placeholder ``...`` of the lesson shows how to write them.
    """
    known = find_questions().explanations
    if name not in known:
        near = nearest(name, known)
        there = f'did you mean explain({near!r}, ...)?' if near else f'{FILE} has no [[explanation]] of this name.'
        return Verdict(f'there is no explanation "{name}": {there}')
    if isinstance(text, EllipsisType):
        return Verdict(
            'Replace the three dots with one or two sentences in quotation marks, and run this cell to see the answer.'
        )
    words = ' '.join(visible(str(text)).split())[:LONGEST]
    if len(words.split()) < FEWEST:
        return Verdict(f'Write at least {FEWEST} words to see the answer.')
    word = keep(lambda file: file.explanations.update({name: words}))
    return Verdict(f'You wrote: {words}', f'Answer: {known[name].answer}', word)
