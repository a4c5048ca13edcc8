"""edugrade: grades ROS 2 launch files by what they do when launched in edulaunch's simulation.

For the author of a rubric::

    from edugrade import Evidence, Missing, Mismatch, Rubric, Scenario, check

In reading order:

- what was handed in: `submission.py`, `source.py`, `files.py`
- what is asked: `rubric.py`, `evidence.py`, `library/`; found by `rubrics/`, `course.py`, `variant.py`
- the runs: `grading.py`, `runner.py`, `job.py`, `child_run.py`, `sandbox/`; `in_place.py` where nothing can be forked
- what they came to: `verdicts.py`, `worker.py`, `judging.py`, `repeated.py`, `results.py`
- the reports: `reports/`; what a student has done: `noted.py`, `progress_file.py`
- who asks: `cli.py` with `options.py`, `notebook.py` with `turn.py`, `pytest_plugin.py`, `course_check.py`
- a plug-in: `classes/`, the tools for whole classes
"""

from __future__ import annotations

from .evidence import Evidence, Failure, Mismatch, Missing, Scenario
from .rubric import Check, Rubric, check

__all__ = ['Check', 'Evidence', 'Failure', 'Mismatch', 'Missing', 'Rubric', 'Scenario', 'check']
