"""Everything that is said to help: rules over facts, and their words.

Lower rooms raise ROS 2's own errors and record facts; here rules look at an error, a dry run, a Recording or a package's
sources and find mistakes, and `told` puts a finding into words at the edge (console, cell, page, report).
`docs/advice.md` lists every rule.
"""

from __future__ import annotations

from edulaunch.advice.failure import Failure
from edulaunch.advice.finding import Finding, found
from edulaunch.advice.judging import judge, judge_failure, judge_plan, judge_sources
from edulaunch.advice.reader import Reader, reader_here
from edulaunch.advice.rule import Rule, rule
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
    'rule',
    'told',
]
