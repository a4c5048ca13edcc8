"""edugrade: grades ROS 2 launch files by what they do when launched in edulaunch's simulation.

For the author of a rubric::

    from edugrade import Evidence, Missing, Mismatch, Rubric, Scenario, check

In reading order: `submission.py` (what was handed in), `rubric.py` and `check.py` (what is asked),
`runner.py` with `child_run.py` and `sandbox/` (the runs), `verdicts.py` and `judging.py` (what they came to),
`terminal.py` and `document.py` (the reports), `cli.py`.
"""

from __future__ import annotations

from .evidence import Evidence, Failure, Mismatch, Missing, Scenario
from .rubric import Check, Rubric, check

__all__ = ['Check', 'Evidence', 'Failure', 'Mismatch', 'Missing', 'Rubric', 'Scenario', 'check']
