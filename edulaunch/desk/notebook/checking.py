"""``check('circle')``: grade an exercise from a notebook, with the rubric that `edugrade` uses."""

from __future__ import annotations

import sys
from typing import Protocol


class Shown(Protocol):
    """A report, a hint or a note: HTML in a notebook, plain text elsewhere."""

    def _repr_html_(self) -> str: ...


def check(exercise: str, *, hint: int | None = None) -> Shown:
    """Grade your launch file, show the report, and write your progress to ``my_progress.toml`` beside the notebook.

    ::

        from edulaunch import check
        check('circle')             # exercises/circle.launch.py, here or in a parent folder
        check('circle', hint=1)     # a question; 2 points to the place, 3 is almost the answer
        check('radio')              # "Your turn" of a lesson, with the rubric in checks/ beside the notebook

    :param exercise: the name of an exercise or of a turn, or the path of a launch file or of a package's folder.
    :param hint: the level of a hint to open (1 to 3); this grades nothing.
    :raises UnusableInput: when there is no such exercise, hint or file, or the grader is not installed.
    """
    from edulaunch.runtime import plugins

    check_in_notebook = plugins.offered('check')
    found: Shown = check_in_notebook(exercise, hint=hint, names=sys._getframe(1).f_globals)
    return found
