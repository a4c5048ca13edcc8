"""Advice for users: rules look for mistakes, and each rule has sentences that explain its mistake.

Lower packages raise ROS 2's own errors and record facts. Rules look for mistakes in an error, a dry run, a Recording or the
sources of a package. `rendered` converts a finding to sentences for the console, a cell, a page or a report. `docs/advice.md`
lists every rule, and `reference.py` determines the page that describes it. An import is inside a function only if most uses of
the module do not need it.
"""

from __future__ import annotations

from importlib import import_module

TYPE_CHECKING = False  # equals `typing.TYPE_CHECKING`, but does not load `typing`
if TYPE_CHECKING:
    from typing import Any

    from edulaunch.advice.judging import judge, judge_failure, judge_plan, judge_sources
    from edulaunch.advice.reader import Reader, reader_here
    from edulaunch.advice.rendering import Rendered, rendered
    from edulaunch.advice.rule import Failure, Finding, Rule, found

_MODULES = {
    **dict.fromkeys(('Failure', 'Finding', 'Rule', 'found'), 'rule'),
    **dict.fromkeys(('judge', 'judge_failure', 'judge_plan', 'judge_sources'), 'judging'),
    **dict.fromkeys(('Reader', 'reader_here'), 'reader'),
    **dict.fromkeys(('Rendered', 'rendered'), 'rendering'),
}
__all__ = [
    'Failure',
    'Finding',
    'Reader',
    'Rule',
    'Rendered',
    'found',
    'judge',
    'judge_failure',
    'judge_plan',
    'judge_sources',
    'reader_here',
    'rendered',
]


def __getattr__(name: str) -> Any:
    """Import the module of a name when the name is first used, so that a run without a finding does not load the rules'
    messages.
    """
    if name not in _MODULES:
        raise AttributeError(f'module {__name__!r} has no attribute {name!r}')
    return getattr(import_module(f'{__name__}.{_MODULES[name]}'), name)
