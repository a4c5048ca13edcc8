"""The dry run: find out what a launch file would do, as plain data, without starting programs.

The real launch service visits the real actions in a separate simulation. Only the host is different (`rehearsal.py`): it records
the programs instead of starting them. The packages of ROS must be on the path (`edulaunch.source()`).
"""

from __future__ import annotations

TYPE_CHECKING = False  # equals `typing.TYPE_CHECKING`, but does not load `typing`
if TYPE_CHECKING:
    from typing import Any

    from edulaunch.advice.plan.dry_run import Rehearsal, rehearse

__all__ = ['Rehearsal', 'rehearse']


def __getattr__(name: str) -> Any:
    if name not in __all__:
        raise AttributeError(f'module {__name__!r} has no attribute {name!r}')
    from edulaunch.advice.plan import dry_run  # imported here, because each launch loads this package only for its trace

    return getattr(dry_run, name)
