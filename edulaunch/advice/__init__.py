"""Everything that is said to help: rules over facts, and their words.

Lower rooms raise ROS 2's own errors and record facts; here rules look at an error, a dry run, a Recording or a package's
sources and find mistakes, and `told` puts a finding into words at the edge (console, cell, page, report).
`docs/advice.md` lists every rule.
"""

from __future__ import annotations

from importlib import import_module

TYPE_CHECKING = False  # as `typing.TYPE_CHECKING`, without loading `typing`
if TYPE_CHECKING:
    from typing import Any

    from edulaunch.advice.failure import Failure
    from edulaunch.advice.finding import Finding, found
    from edulaunch.advice.judging import judge, judge_failure, judge_plan, judge_sources
    from edulaunch.advice.reader import Reader, reader_here
    from edulaunch.advice.rule import Rule
    from edulaunch.advice.wording import Told, told

__all__ = [
    'Failure',
    'Finding',
    'Reader',
    'Rule',
    'Told',
    'found',
    'judge',
    'judge_failure',
    'judge_plan',
    'judge_sources',
    'reader_here',
    'told',
]
_MODULES = {
    'Failure': 'failure',
    'Reader': 'reader',
    'reader_here': 'reader',
    'Rule': 'rule',
    'Told': 'wording',
    'told': 'wording',
}


def __getattr__(name: str) -> Any:
    """Each name when it is first used: who judges a run without a finding loads no words."""
    if name not in __all__:
        raise AttributeError(f'module {__name__!r} has no attribute {name!r}')
    module = _MODULES.get(name) or ('judging' if name.startswith('judge') else 'finding')
    return getattr(import_module(f'{__name__}.{module}'), name)
