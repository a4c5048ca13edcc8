"""``check('circle')``: grade an exercise from a notebook, with the same rubric as `edugrade`."""

from __future__ import annotations

import sys
from typing import Protocol


class Shown(Protocol):
    """A report, a hint or a note. It is HTML in a notebook, and plain text elsewhere."""

    def _repr_html_(self) -> str: ...


def check(exercise: str, *, hint: int | None = None) -> Shown:
    """Grade your launch file, show the report, and save your progress in ``my_progress.toml`` beside the notebook.

    ::

        from edulaunch import check
        check('circle')             # exercises/circle.launch.py, here or in a parent folder
        check('circle', hint=1)     # a question; 2 points to the place, 3 is almost the answer
        check('radio')              # "Your turn" of a lesson, with the rubric in checks/ beside the notebook

    :param exercise: the name of an exercise or of a "Your turn" task, or the path of a launch file or of a package's folder.
    :param hint: the level of the hint to show (1 to 3). With a hint, nothing is graded.
    :raises UnusableInput: when there is no such exercise, hint or file, or the grader is not installed.
    """
    from edulaunch.runtime import plugins

    check_in_notebook = plugins.offered('check')
    found: Shown = check_in_notebook(exercise, hint=hint, names=sys._getframe(1).f_globals)
    return found
