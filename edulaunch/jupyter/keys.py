"""A keyboard in a notebook: buttons and a line of text for a program that reads one."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

BUTTONS = {'arrow-up': '\x1b[A', 'arrow-down': '\x1b[B', 'arrow-left': '\x1b[D', 'arrow-right': '\x1b[C'}
"""Icons, and what a terminal sends for these keys."""


def keyboard(press: Callable[[str], str], title: str) -> Any:
    """A widget; each press gives the keys to `press`, and shows what that returns.

    :raises ImportError: without ipywidgets.
    """
    from ipywidgets import Button, HBox, Label, Output, Text, VBox

    shown = Output()

    def pressed(keys: str) -> None:
        said = press(keys)
        shown.append_stdout(said)

    def button(icon: str, keys: str) -> Any:
        made = Button(icon=icon, tooltip=icon, layout={'width': '3em'})
        made.on_click(lambda _: pressed(keys))
        return made

    def entered(text: Any) -> None:
        keys, text.value = text.value, ''
        pressed(keys if len(keys) == 1 else f'{keys}\n')

    line = Text(placeholder='a key, or a line, then Enter', continuous_update=False)
    line.observe(lambda change: entered(line) if change.new else None, 'value')
    keys = HBox([*(button(*each) for each in BUTTONS.items()), line])
    return VBox([Label(f'keyboard of {title}: each press lets one second pass'), keys, shown])
