"""Widgets: `edulaunch.interact` runs again with other numbers by moving sliders, and a keyboard for a program that reads one."""

from __future__ import annotations

from collections.abc import Callable
from functools import wraps
from typing import Any

from edulaunch.desk.machine.sliders import widgets
from edulaunch.engine.recording import Recording
from edulaunch.errors import EdulaunchError

BUTTONS = {'arrow-up': '\x1b[A', 'arrow-down': '\x1b[B', 'arrow-left': '\x1b[D', 'arrow-right': '\x1b[C'}
"""Icons, and what a terminal sends for these keys."""


def interact(run: Callable[..., Any], **choices: Any) -> Any:
    """A widget with a slider or another choice for each argument of a function; what it returns is shown below.

    ::

        def circle(radius):
            return edulaunch.run('circle.launch.py', arguments={'circle_radius': radius}, duration_s=20)

        edulaunch.interact(circle, radius=(0.5, 2.0))

    It runs when a slider is let go, not while it moves: a run takes a moment. A Recording is shown as its turtles.

    :param choices: as ipywidgets abbreviates them: (least, most), (least, most, step), a list, True, a text, or a widget.
    :raises UnusableInput: when ipywidgets is not installed.
    """
    ipywidgets = widgets()

    @wraps(run)
    def shown(**values: Any) -> None:
        from IPython.display import display

        try:
            result = run(**values)
        except EdulaunchError as error:
            print(f'error: {error}')
            return
        if result is not None:
            display(result.plot_turtles() if isinstance(result, Recording) else result)  # type: ignore[no-untyped-call]

    made = ipywidgets.interactive(shown, **choices)
    for control in made.children[:-1]:
        if control.has_trait('continuous_update'):
            control.continuous_update = False
    return made


def keyboard(press: Callable[[str], str], title: str) -> Any:
    """A widget; each press gives the keys to `press`, and shows what that returns.

    :raises ImportError: without ipywidgets.
    """
    from ipywidgets import Button, HBox, Label, Output, Text, VBox

    shown = Output()

    def pressed(keys: str) -> None:
        printed = press(keys)
        shown.append_stdout(printed)

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
