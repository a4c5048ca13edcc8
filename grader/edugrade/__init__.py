"""edugrade: grades ROS 2 launch files by what they do when edulaunch launches them in its simulation.

The author of a rubric imports these names::

    from edugrade import Evidence, Missing, Mismatch, Rubric, Scenario, check

In reading order:

- submissions: `submission.py`, `source.py`, `files.py`
- input: `rubric.py`, `evidence.py`, `library/`, `rubrics/`, `course.py`, `variant.py`
- runs: `grading.py`, `runner.py`, `job.py`, `places.py`, `child_run.py`, `starter_link.py`, `sandbox/`, and `in_place.py` for
  systems without fork
- results: `verdicts.py`, `worker.py`, `judging.py`, `repeated.py`, `results.py`
- output: `reports/`, `attempts.py`, `progress_file.py`
- entry points: `cli.py` with `options.py`, `notebook.py` with `turn.py`, `pytest_plugin.py`, `course_check.py`
- a plug-in: `classes/`, the tools for whole classes

An import is inside a function only if most uses of the module do not need it.
"""

from __future__ import annotations

from importlib import import_module

TYPE_CHECKING = False  # equals `typing.TYPE_CHECKING`, but does not load `typing`
if TYPE_CHECKING:
    from typing import Any

    from .evidence import Evidence, Failure, Mismatch, Missing, Scenario
    from .rubric import Check, Rubric, check

_MODULES = {
    **dict.fromkeys(('Evidence', 'Failure', 'Mismatch', 'Missing', 'Scenario'), 'evidence'),
    **dict.fromkeys(('Check', 'Rubric', 'check'), 'rubric'),
}
__all__ = ['Check', 'Evidence', 'Failure', 'Mismatch', 'Missing', 'Rubric', 'Scenario', 'check']


def __getattr__(name: str) -> Any:
    """Import a name when it is first used, so that a command that only looks for plug-ins loads no rubrics."""
    if name not in _MODULES:
        raise AttributeError(f'module {__name__!r} has no attribute {name!r}')
    return getattr(import_module(f'{__name__}.{_MODULES[name]}'), name)
