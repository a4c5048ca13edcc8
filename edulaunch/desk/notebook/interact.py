"""Widgets: `edulaunch.interact` runs a function for the values of sliders, and `keyboard` sends keys to a program."""

from __future__ import annotations

from collections.abc import Callable
from functools import wraps
from typing import Any

from edulaunch.desk.machine.sliders import widgets
from edulaunch.engine.recording import Recording
from edulaunch.errors import EdulaunchError

BUTTONS = {'arrow-up': '\x1b[A', 'arrow-down': '\x1b[B', 'arrow-left': '\x1b[D', 'arrow-right': '\x1b[C'}
"""Icons, and the bytes that a terminal sends for these keys."""


def interact(run: Callable[..., Any], **choices: Any) -> Any:
    """Show a slider or another control for each argument of a function, and the result of the function below the controls.

    ::

        def circle(radius):
            return edulaunch.run('circle.launch.py', arguments={'circle_radius': radius}, duration_s=20)

        edulaunch.interact(circle, radius=(0.5, 2.0))

    The function runs when the user releases a slider, because a run takes a moment. If the function returns a Recording, the
    widget shows a picture of its turtles.

    :param run: the function. It receives the values of the controls as keyword arguments.
    :param choices: the controls by argument, in the short form of ipywidgets: (min, max), (min, max, step), a list, True, a
        string, or a widget.
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
    """Return a keyboard widget. Each press of a button sends its keys to `press`, and shows the string that `press` returns.

    :param press: the function that receives the keys.
    :param title: the title of the widget.
    :raises ImportError: when ipywidgets is not installed.
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

    line = Text(placeholder='a key, or a line, followed by Enter', continuous_update=False)
    line.observe(lambda change: entered(line) if change.new else None, 'value')
    keys = HBox([*(button(*each) for each in BUTTONS.items()), line])
    return VBox([Label(f'keyboard of {title}: one second passes with each press'), keys, shown])
