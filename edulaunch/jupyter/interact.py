"""`edulaunch.interact`: run again with other numbers by moving sliders."""

from __future__ import annotations

from collections.abc import Callable
from functools import wraps
from typing import Any

from edulaunch.errors import EdulaunchError
from edulaunch.machine.sliders import widgets
from edulaunch.recording import Recording


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
