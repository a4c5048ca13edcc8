"""A question with a button for each choice. Loaded late: it needs ipywidgets."""

from __future__ import annotations

from collections.abc import Callable
from html import escape
from typing import Any

import ipywidgets

from .predictions import Words
from .questions import LETTERS, Question


def quiz_widget(question: Question, answer: Callable[[str], Words]) -> dict[str, Any]:
    """The mime bundle of the question, its choices, and a button for each; a click shows what is told below.

    :param answer: called with the letter that was chosen.
    """
    choices = ''.join(f'<li>{escape(choice.text)}</li>' for choice in question.choices)
    text = f'<p><b>{escape(question.text)}</b></p><ol type="a" style="line-height:1.5">{choices}</ol>'
    told = ipywidgets.HTML()

    def clicked(button: Any) -> None:
        told.value = f'<p aria-live="polite"><b>{button.description})</b> {escape(repr(answer(button.description)))}</p>'

    row = [_button(letter, choice.text) for letter, choice in zip(LETTERS, question.choices, strict=False)]
    for button in row:
        button.on_click(clicked)
    bundle: dict[str, Any] = ipywidgets.VBox([ipywidgets.HTML(text), ipywidgets.HBox(row), told])._repr_mimebundle_()
    return bundle


def _button(letter: str, text: str) -> Any:
    return ipywidgets.Button(description=letter, tooltip=text, layout=ipywidgets.Layout(width='3em'))
