"""Functions for lessons: predictions, questions, explanations, and a page that shows a student's progress.

Lessons use them like this::

        from edulaunch.course import compare, explain, predict, progress, quiz
        predict('square-end', (7.5, 5.5))      # before the run: stored in my_progress.toml
        compare('square-end', (5.5, 5.5))      # after the run: "You predicted ..., the result is ..."
        quiz('remapping', ...)                 # a question with choices; quiz('remapping', 'b') answers it
        explain('why-twice', ...)              # write a sentence in place of the dots to see the answer
        progress()                             # lessons, predictions, questions, exercises, and what to repeat

The answers never leave the computer: they are in a small readable file beside the notebook.
An import is inside a function only if most uses of the module do not need it.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from .explanations import explain
    from .predictions import compare, predict
    from .progress_page import progress
    from .quizzes import quiz

__all__ = ['compare', 'explain', 'predict', 'progress', 'quiz']
_PLACES = {
    'compare': 'predictions',
    'explain': 'explanations',
    'predict': 'predictions',
    'progress': 'progress_page',
    'quiz': 'quizzes',
}


def __getattr__(name: str) -> Any:
    """Load a function when a lesson first uses it, because the command line needs only `plugin.py`."""
    if name not in _PLACES:
        raise AttributeError(f'module {__name__!r} has no attribute {name!r}')
    return getattr(import_module(f'.{_PLACES[name]}', __name__), name)
