"""The dry run: what a launch file would do, as plain data, without starting anything.

The real launch service visits the real actions in a simulation of its own; only the host is another one
(`rehearsal.py`), which notes what it is asked to start. Needs the faces on the path (`edulaunch.source()`).
"""

from __future__ import annotations

from edulaunch.advice.plan.make_plan import Rehearsal, make_plan, rehearse

__all__ = ['Rehearsal', 'make_plan', 'rehearse']
